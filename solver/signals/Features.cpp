#include "signals/Features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "signals/Alignment.h"
#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

void requireOptions(const TimeSeries& series, const FeatureOptions& options) {
  std::ostringstream text;
  const auto positive = [&](double value, const char* what) {
    if (!(std::isfinite(value) && value > 0) && text.str().empty())
      text << what << " must be a positive number, not " << value;
  };
  positive(options.speed, "the speed in m/s");
  positive(options.before, "the length before the impact in m");
  positive(options.after, "the length after the impact in m");
  positive(options.waveSpan, "the length for the mean wavelength in m");
  positive(options.rmsLength, "the length of the moving rms in m");
  auto bands = options.bands;
  bands.push_back(options.waveBand);
  for (const auto& band : bands) {
    if (!text.str().empty()) break;
    if (!(band.low > 0 && band.high > band.low))
      text << "the band " << band.low << " to " << band.high << " Hz needs two rising, positive frequencies";
    else if (band.required && !shows(series.rate(), band))
      text << "the band " << band.low << " to " << band.high << " Hz needs a sampling rate above " << 2 * band.high
           << " Hz; signal '" << series.name << "' has " << series.rate() << " Hz";
  }
  if (!text.str().empty()) throw SignalError(text.str());
}

}  // namespace

std::size_t largestSample(const std::vector<double>& values) {
  return static_cast<std::size_t>(
      std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      values.begin());
}

std::vector<SpectralPeak> namedLines(const PowerSpectrum& spectrum) {
  auto lines = spectralPeaks(spectrum, 50, 2000, 0.05);
  if (lines.size() > 6) lines.resize(6);
  return lines;
}

std::vector<Band> squatBands() {
  return {{"130-320 Hz", 130, 320, false}, {"200-400 Hz", 200, 400, false}, {"1000-1200 Hz", 1000, 1200, false}};
}

bool shows(double rate, const Band& band) { return band.high < rate / 2; }

std::vector<double> movingRms(const std::vector<double>& values, std::size_t n) {
  const std::size_t size = values.size();
  std::vector<double> sums(size + 1, 0.0), result(size);
  for (std::size_t i = 0; i < size; ++i) sums[i + 1] = sums[i] + values[i] * values[i];
  n = std::max<std::size_t>(n, 1);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t from = i > n / 2 ? i - n / 2 : 0, to = std::min(size, i + n - n / 2);
    result[i] = std::sqrt((sums[to] - sums[from]) / static_cast<double>(to - from));
  }
  return result;
}

PowerSpectrum localSpectrum(const TimeSeries& series, double from, double to, Window window) {
  constexpr double frequencyStep = 3;  // [Hz]
  const TimeSeries part = cutOut(series, from, to);
  PowerSpectrumOptions options;
  options.window = window;
  options.transformLength =
      fastLength(std::max(part.values.size(), static_cast<std::size_t>(std::ceil(series.rate() / frequencyStep))));
  return powerSpectrum(part, options);
}

PowerSpectrum stretchSpectrum(const Passage& passage, double from, double to, Window window) {
  const auto options = anchored(passage);
  const Anchor anchor = *options.anchor;
  const double zero = anchor.rule == AnchorRule::defect ? 0 : positionAtTime(passage, anchor.time);
  const auto timeOf = [&](double position) { return anchor.time + (position - zero) / options.speed; };
  return localSpectrum(passage.series, timeOf(from), timeOf(to), window);
}

FeatureOptions anchored(const Passage& passage, FeatureOptions options) {
  if (!options.anchor) options.anchor = anchorOf(passage);
  if (passage.position.size() < 2) return options;
  if (const double speed = speedAt(passage, options.anchor->time); speed > 0) options.speed = speed;
  return options;
}

Features features(const Passage& passage, const FeatureOptions& options) {
  return features(passage.series, anchored(passage, options));
}

Features features(const TimeSeries& series, const FeatureOptions& options) {
  requireUsable(series, 32, "the table of features");
  requireVarying(series, "the table of features");
  requireOptions(series, options);
  Features result;
  result.name = series.name;
  result.unit = series.unit;
  result.speed = options.speed;
  const Anchor anchor =
      options.anchor.value_or(Anchor{series.timeAt(largestSample(series.values)), AnchorRule::largestValue});
  result.impactTime = anchor.time;
  result.anchor = anchor.rule;
  const auto [lowest, highest] = std::minmax_element(series.values.begin(), series.values.end());
  result.minimum = *lowest;
  result.maximum = *highest;
  result.peak = std::max(-*lowest, *highest);
  result.peakToPeak = *highest - *lowest;
  result.rms = movingRms(series.values, 2 * series.values.size()).front();
  const double rmsSamples = std::round(options.rmsLength / options.speed / series.step);
  const auto window = static_cast<std::size_t>(std::clamp(rmsSamples, 1.0, static_cast<double>(series.values.size())));
  const auto moving = movingRms(series.values, window);
  // Whole windows only: at the ends of the record fewer samples stand behind a value.
  const auto half = static_cast<std::ptrdiff_t>(window / 2);
  result.largestMovingRms =
      *std::max_element(moving.begin() + half, moving.end() - (static_cast<std::ptrdiff_t>(window) - half - 1));

  const double impact = result.impactTime, speed = options.speed;
  result.spectrum = localSpectrum(series, impact - options.before / speed, impact + options.after / speed);
  constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
  const bool waves = shows(series.rate(), options.waveBand);
  const double until = impact + options.waveSpan / speed;
  result.wavelengthByCrossings = waves ? wavelengthByCrossings(series, impact, until, speed, options.waveBand) : unseen;
  result.wavelengthByRidge = waves ? wavelengthByRidge(series, impact, until, speed, options.waveBand) : unseen;
  for (const Band& band : options.bands) {
    if (!shows(series.rate(), band)) {
      result.bands.push_back({band, unseen, unseen, unseen, unseen});
      continue;
    }
    const double power = bandPower(result.spectrum, band.low, band.high);
    const auto vibration = freeVibration(series, impact, band, options.decayLevel);
    result.bands.push_back({band, power, power / result.spectrum.integral,
                            vibration.ended ? vibration.duration : unseen, vibration.duration});
  }
  result.peaks = spectralPeaks(result.spectrum, options.lowestPeak, options.highestPeak, options.peakShare);
  return result;
}

std::vector<std::pair<std::string, double>> featureRow(const Features& f, std::size_t peakCount) {
  const std::string name = f.unit.empty() ? "unit" : f.unit;
  const std::string unit = " [" + name + "]", square = " [(" + name + ")2]";
  std::vector<std::pair<std::string, double>> row{{"speed [m/s]", f.speed},
                                                  {"impact time [s]", f.impactTime},
                                                  {"peak" + unit, f.peak},
                                                  {"maximum" + unit, f.maximum},
                                                  {"minimum" + unit, f.minimum},
                                                  {"peak to peak" + unit, f.peakToPeak},
                                                  {"rms" + unit, f.rms},
                                                  {"largest moving rms" + unit, f.largestMovingRms},
                                                  {"wavelength by crossings [m]", f.wavelengthByCrossings},
                                                  {"wavelength by ridge [m]", f.wavelengthByRidge}};
  for (const auto& band : f.bands) row.emplace_back("power " + band.band.name + square, band.power);
  for (const auto& band : f.bands) row.emplace_back("free vibration " + band.band.name + " [s]", band.freeVibration);
  for (std::size_t i = 0; i < peakCount; ++i) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const SpectralPeak peak = i < f.peaks.size() ? f.peaks[i] : SpectralPeak{none, none, none, none};
    const std::string which = "peak " + std::to_string(i + 1);
    row.emplace_back(which + " frequency [Hz]", peak.frequency);
    row.emplace_back(which + " width [Hz]", peak.width);
    row.emplace_back(which + " prominence [(" + name + ")2/Hz]", peak.prominence);
  }
  row.emplace_back("spectrum integral" + square, f.spectrum.integral);
  row.emplace_back("spectrum mean square" + square, f.spectrum.meanSquare);
  return row;
}

}  // namespace squat::signals
