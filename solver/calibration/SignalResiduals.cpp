#include "calibration/SignalResiduals.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "signals/Features.h"
#include "signals/PowerSpectrum.h"
#include "signals/Resample.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::calibration {

namespace {

signals::Passage filtered(signals::Passage passage, double cutoff) {
  passage.series = signals::filteredPartner(passage.series, cutoff);
  return passage;
}

double largest(const std::vector<double>& values) {
  double maximum = 0;
  for (const double value : values) maximum = std::max(maximum, std::abs(value));
  return maximum;
}

std::vector<signals::Passage> runsOf(const SignalTarget& target, std::vector<std::string>& notes) {
  std::vector<signals::Passage> runs;
  for (const auto& file : target.files)
    for (const auto& record : readers::readSignals(file, target.reading)) {
      const auto& unit = record.signals.front().unit;
      if (unit.empty())
        throw FileError(file, record.run, "the signal has no unit",
                        "Write the unit into the heading of the column, as in \"aba [m/s2]\"");
      if (unit != "m/s2")
        throw FileError(file, record.run, "unit is '" + unit + "', must be an acceleration (m/s2, g)",
                        "Choose the column of the axle box acceleration with \"column\"");
      for (const auto& note : record.notes) notes.push_back(target.name + ": " + note);
      auto passage = readers::passageWithPositions(record);
      if (!signals::carriesFilter(passage.series, target.cutoff))
        throw FileError(file, record.run,
                        "is sampled at " + text::roundedText(passage.series.rate()) +
                            " Hz, too slowly for a cut-off at " + text::roundedText(target.cutoff) + " Hz",
                        "Give a lower \"cutoff\" in a target file");
      runs.push_back(filtered(std::move(passage), target.cutoff));
    }
  return runs;
}

// The mean over aligned runs as a passage of its own, and its standard error from their scatter.
signals::Passage meanOf(const std::vector<signals::Passage>& runs, const SignalTarget& target, double& error) {
  signals::AlignmentOptions options;
  options.before = target.before, options.after = target.after;
  const auto aligned = signals::alignInPosition(runs, options);
  double sum = 0;
  std::size_t count = 0;
  for (const auto& row : aligned.values)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (aligned.axis[i] >= -target.before && aligned.axis[i] <= target.after)
        sum += std::pow(row[i] - aligned.mean[i], 2), ++count;
  if (count == 0) throw signals::SignalError("the runs have no length in common around the defect");
  const double runCount = static_cast<double>(runs.size());
  error = std::sqrt(sum / static_cast<double>(count) / (runCount - 1));  // scatter over the root of the runs
  const double speed = aligned.speed.front();
  signals::Passage mean;
  mean.series.step =
      (aligned.axis.back() - aligned.axis.front()) / static_cast<double>(aligned.axis.size() - 1) / speed;
  mean.series.start = aligned.axis.front() / speed;
  mean.series.values = aligned.mean;
  mean.position = aligned.axis;
  return mean;
}

// Levels [dB] in one-third octaves from 160 to 1600 Hz, the noise of the measured signal added to the other.
std::vector<double> levels(const std::vector<double>& values, double step, double noiseDensity) {
  constexpr double lowest = 160, highest = 1700;
  const double third = std::pow(2.0, 1.0 / 3), half = std::pow(2.0, 1.0 / 6);
  signals::PowerSpectrumOptions options;
  options.transformLength = 4 * values.size();
  const auto spectrum = signals::powerSpectrum({0, step, values, "", "m/s2"}, options);
  std::vector<double> all;
  for (double centre = lowest; centre < highest; centre *= third) {
    const double low = centre / half, high = std::min(centre * half, 0.499 / step);
    if (low >= high) break;
    all.push_back(10 * std::log10(signals::bandPower(spectrum, low, high) + noiseDensity * (high - low) + 1e-12));
  }
  return all;
}

double levelMisfit(const std::vector<double>& computed, const std::vector<double>& measured, double step,
                   const MeasuredSignal& signal) {
  constexpr double allowed = 2;  // [dB]
  const auto ours = levels(computed, step, signal.noise * signal.noise / signal.target.cutoff);
  const auto theirs = levels(measured, step, 0);
  double sum = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) sum += std::pow((ours[i] - theirs[i]) / allowed, 2);
  return sum / static_cast<double>(std::max<std::size_t>(ours.size(), 1));
}

}  // namespace

MeasuredSignal readMeasured(const SignalTarget& target) {
  MeasuredSignal measured{target, {}, 0, 0, {}};
  std::vector<signals::Passage> runs;
  try {
    runs = runsOf(target, measured.notes);
    double error = 0;
    measured.mean = runs.size() > 1 ? meanOf(runs, target, error) : runs.front();
    measured.peak = largest(measured.mean.series.values);
    constexpr double oneRun = 0.1;
    if (target.noise > 0)
      measured.noise = target.noise * measured.peak;
    else
      measured.noise = runs.size() > 1 ? error : oneRun * measured.peak;
  } catch (const signals::SignalError& error) {
    throw FileError(target.files.front(), "", error.what());
  } catch (const CaseError& error) {  // neither speed nor position
    throw FileError(target.files.front(), "", error.what(), "Give \"speed\" and \"rate\" in a target file");
  }
  if (!(measured.noise > 0) && runs.size() > 1)
    throw FileError(target.files.front(), "", "its runs do not differ from each other",
                    "Give each run once, or \"noise\" in a target file");
  if (!(measured.noise > 0)) throw FileError(target.files.front(), "", "holds no vibration: every sample is the same");
  return measured;
}

TargetValue signalValue(const MeasuredSignal& measured, const results::RunResult& result) {
  TargetValue value;
  value.misfit = kMissingResidual * kMissingResidual * 4;
  try {
    const auto& target = measured.target;
    auto computed = filtered(signals::passageOf(result, signals::names::axleBox), target.cutoff);
    signals::AlignmentOptions options;
    options.before = target.before, options.after = target.after;
    options.anchor = signals::timeAtPosition(computed, 0.0);
    const auto both = signals::alignInPosition({computed, measured.mean}, options);
    const double speed = both.speed.front();
    const double step = speed / (2 * target.cutoff);  // [m]: two samples a period of the cut-off frequency
    std::vector<double> ours, theirs;
    const double first = std::max(-target.before, both.axis.front()), last = std::min(target.after, both.axis.back());
    // A whole number of steps may be a little less by rounding: the number of residuals must not hang on that.
    const auto count = static_cast<long>(std::floor((last - first) / step + 1e-3)) + 1;
    if (count < 2) throw signals::SignalError("too short to compare");
    for (long i = 0; i < count; ++i) {
      const double x = first + static_cast<double>(i) * step;
      ours.push_back(signals::interpolateLinear(both.axis, both.values[0], x));
      theirs.push_back(signals::interpolateLinear(both.axis, both.values[1], x));
      value.residuals.push_back((ours.back() - theirs.back()) / measured.noise);
    }
    double sum = 0;
    for (const double residual : value.residuals) sum += residual * residual;
    const double mean = sum / static_cast<double>(value.residuals.size());
    value.value = std::sqrt(mean);
    value.isMet = *value.value <= 1.5;  // the noise, and half as much again of the model's own
    value.misfit = mean + levelMisfit(ours, theirs, step / speed, measured);
  } catch (const signals::SignalError&) {  // too short to compare
    value.residuals.clear(), value.value.reset(), value.isMet = false;
  }
  return value;
}

}  // namespace squat::calibration
