#include "analysis/Analysis.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "analysis/Maps.h"
#include "core/Errors.h"
#include "signals/Butterworth.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::analysis {
namespace {

constexpr std::size_t longestPeriodogram = 16384, usualSegment = 8192;

// The stretch that is shown; all of a record with too few samples there. Columns are made for that stretch alone:
// spread over a long record, they would average the impact away.
std::pair<double, double> shownStretch(const signals::TimeSeries& series, const signals::Features& features,
                                       const signals::FeatureOptions& options) {
  constexpr double fewSamples = 32;
  const double last = series.timeAt(series.values.size() - 1);
  const double from = std::max(series.start, features.impactTime - options.before / features.speed);
  const double to = std::min(last, features.impactTime + options.after / features.speed);
  return to - from > fewSamples * series.step ? std::pair(from, to) : std::pair(series.start, last);
}

// A band that was not requested and that the sampling rate cannot show is left out, with a note.
void noteUnseenBands(double rate, const signals::FeatureOptions& options, std::vector<std::string>& notes) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (const auto& band : options.bands)
    if (!band.required && !signals::shows(rate, band)) add(band.name);
  const auto& waves = options.waveBand;
  if (!waves.required && !signals::shows(rate, waves))
    add("the wavelength (" + text::formatted("%g Hz", waves.low) + " to " + text::formatted("%g Hz", waves.high) + ")");
  if (!names.empty())
    notes.push_back("left out at a sampling rate of " + text::formatted("%g Hz", rate) + ": " + names);
}

// Of what still rings when the record ends only a lower limit is known.
void noteUnendedVibration(const signals::Features& features, std::vector<std::string>& notes) {
  std::string names;
  for (const auto& band : features.bands) {
    if (std::isnan(band.ringsFor) || !std::isnan(band.freeVibration)) continue;
    std::ostringstream text;
    text.precision(3);
    text << band.band.name << " (longer than " << 1e3 * band.ringsFor << " ms)";
    names += (names.empty() ? "" : ", ") + text.str();
  }
  if (!names.empty()) notes.push_back("free vibration not over at the end of the record: " + names);
}

void noteMissingWavelength(double rate, const signals::Features& features, const signals::FeatureOptions& options,
                           std::vector<std::string>& notes) {
  if (signals::shows(rate, options.waveBand) && std::isnan(features.wavelengthByCrossings))
    notes.push_back("no wavelength by crossings: fewer than three zero crossings after the impact");
}

// A window weighs the samples of a record that is not stationary differently; then the density's integral is another
// mean square than the record's.
void noteUnevenWindow(const signals::PowerSpectrum& spectrum, std::vector<std::string>& notes) {
  const double ratio = spectrum.meanSquare > 0 ? spectrum.integral / spectrum.meanSquare : 1.0;
  if (std::abs(ratio - 1) <= 0.02) return;
  std::ostringstream text;
  text.precision(3);
  text << "the integral of the PSD is " << ratio
       << " of the mean square: the window weights the middle of each segment of a non-stationary record more; "
          "a boxcar window gives 1";
  notes.push_back(text.str());
}

// The message of a signal with its place in a file.
FileError inFile(const signals::Record& signal, const signals::SignalError& error) {
  std::string location = signal.run;
  if (error.sample()) location += ", sample " + std::to_string(*error.sample());
  return FileError(signal.file, location, error.what());
}

void alignRuns(Analysis& analysis, const AnalysisOptions& options) {
  std::vector<signals::Passage> runs;
  for (const auto& signal : analysis.signals) {
    runs.push_back({signal.filtered, signal.passage.position});
    runs.back().series.name = signal.run;
    if (runs.back().series.unit != runs.front().series.unit) {
      analysis.notes.push_back("runs not aligned: their units differ");
      return;
    }
  }
  try {
    auto alignment = options.alignment;
    if (!alignment.anchor) alignment.anchor = analysis.signals.front().features.impactTime;
    analysis.inTime = signals::alignInTime(runs, alignment);
    analysis.inPosition = signals::alignInPosition(runs, alignment);
    analysis.dispersion = signals::runDispersion(*analysis.inTime, options.features);
  } catch (const signals::SignalError& error) {
    analysis.inTime.reset();
    analysis.inPosition.reset();
    analysis.notes.push_back(std::string("runs not aligned: ") + error.what());
  }
}

}  // namespace

SignalAnalysis analyseSignal(const signals::Record& signal, const AnalysisOptions& options) {
  SignalAnalysis result;
  result.file = signal.file;
  result.run = signal.run;
  result.notes = signal.notes;
  result.passage = readers::passageWithPositions(signal);
  const auto& series = result.passage.series;
  signals::requireUsable(series, 32, "the analysis");
  signals::requireVarying(series, "the analysis");
  result.filtered = series;
  if (options.lowPass > 0 && options.lowPass < 0.49 * series.rate())
    result.filtered = signals::lowPass(series, options.lowPass);
  else if (options.lowPass > 0)
    result.notes.push_back("not low-pass filtered at " + text::formatted("%g Hz", options.lowPass) +
                           ": the sampling rate is " + text::formatted("%g Hz", series.rate()));
  if (!signal.run.empty()) result.filtered.name = signal.run;

  noteUnseenBands(series.rate(), options.features, result.notes);
  const signals::Passage filtered{result.filtered, result.passage.position};
  const auto features = signals::anchored(filtered, options.features);
  result.features = signals::features(result.filtered, features);
  noteUnendedVibration(result.features, result.notes);
  noteMissingWavelength(series.rate(), result.features, features, result.notes);

  signals::PowerSpectrumOptions spectrum = options.spectrum;
  if (spectrum.segment == 0 && result.filtered.values.size() > longestPeriodogram) spectrum.segment = usualSegment;
  result.spectrum = signals::powerSpectrum(result.filtered, spectrum);
  noteUnevenWindow(result.spectrum, result.notes);
  result.stft = stftMap(result.filtered, options.stft, result.notes);
  result.scalogramByAmplitude = options.wavelet.normalisation == signals::WaveletNormalisation::amplitude;
  auto wavelet = options.wavelet;
  if (!wavelet.shown) wavelet.shown = shownStretch(result.filtered, result.features, features);
  result.scalogram = scalogramMap(result.filtered, wavelet, result.notes);
  const double zero = signals::positionAtTime(filtered, features.anchor->time);
  for (const double time : result.scalogram.time)
    result.scalogramPosition.push_back(signals::positionAtTime(filtered, time) - zero);
  return result;
}

Analysis analyse(const std::vector<std::string>& files, const AnalysisOptions& options, Monitor& monitor) {
  if (files.empty()) throw CaseError({{"SIGNAL", "none", "at least one file", "Name the files to analyse"}});
  Analysis analysis;
  for (std::size_t i = 0; i < files.size(); ++i) {
    Progress progress;
    progress.phase = "analysing " + std::filesystem::path(files[i]).filename().string();
    progress.fraction = static_cast<double>(i) / static_cast<double>(files.size());
    monitor.report(progress);
    for (const auto& signal : readers::readSignals(files[i], options.file)) {
      if (monitor.cancelled()) {
        analysis.notes.push_back("cancelled: the remaining signals were not analysed");
        return analysis;
      }
      try {
        analysis.signals.push_back(analyseSignal(signal, options));
      } catch (const signals::SignalError& error) {
        throw inFile(signal, error);
      }
    }
  }
  // Runs of several files need names that tell them apart.
  if (files.size() > 1)
    for (auto& signal : analysis.signals) {
      const std::string stem = std::filesystem::path(signal.file).stem().string();
      signal.run = stem + (signal.run.empty() || signal.run == stem ? "" : ": " + signal.run);
      signal.features.name = signal.filtered.name = signal.run;
    }
  if (options.align && analysis.signals.size() > 1) alignRuns(analysis, options);
  return analysis;
}

}  // namespace squat::analysis
