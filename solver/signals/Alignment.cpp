#include "signals/Alignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

void requirePassages(const std::vector<Passage>& runs) {
  if (runs.size() < 2) throw SignalError("alignment needs at least two runs");
  for (const auto& run : runs) {
    requireUsable(run.series, 16, "alignment");
    requireVarying(run.series, "alignment");
    requireRisingPositions(run);
  }
}

// The run as a series over position: `start` and `step` in metres; low-passed first where the new step is longer.
TimeSeries overPosition(const Passage& run, double step) {
  const double own = (run.position.back() - run.position.front()) / static_cast<double>(run.position.size() - 1);
  const Interpolator at(run.series, step > own * (1 + 1e-9) ? std::min(1.0, 0.9 * own / step) : 1.0);
  if (!((run.position.back() - run.position.front()) / step < 2e7))
    throw SignalError("signal '" + run.series.name + "' would have more than 2e7 samples over its position");
  TimeSeries result{std::ceil(run.position.front() / step) * step, step, {}, run.series.name, run.series.unit};
  std::size_t i = 0;
  for (double x = result.start; x <= run.position.back(); x = result.timeAt(result.values.size())) {
    while (i + 2 < run.position.size() && run.position[i + 1] <= x) ++i;
    const double part = (x - run.position[i]) / (run.position[i + 1] - run.position[i]);
    result.values.push_back(at(run.series.start + run.series.step * (static_cast<double>(i) + part)));
  }
  return result;
}

// Aligns series over any axis; `before` and `after` are lengths on that axis.
AlignedRuns align(const std::vector<TimeSeries>& rows, double anchor, double before, double after,
                  double largestShift) {
  const TimeSeries& reference = rows.front();
  const double last = static_cast<double>(reference.values.size() - 1);
  const double sample = std::clamp(std::round((anchor - reference.start) / reference.step), 0.0, last);
  const double impact = reference.timeAt(static_cast<std::size_t>(sample));
  const TimeSeries piece = cutOut(reference, impact - before, impact + after);
  AlignedRuns result;
  double from = reference.start - impact, to = reference.timeAt(reference.values.size() - 1) - impact;
  for (const auto& row : rows) {
    const bool first = &row == &reference;
    const double at = first ? impact : impact + shiftBetween(piece, row, largestShift);
    result.impact.push_back(at);
    result.names.push_back(row.name);
    from = std::max(from, row.start - at);
    to = std::min(to, row.timeAt(row.values.size() - 1) - at);
  }
  const auto firstIndex = static_cast<long>(std::ceil(from / reference.step - 1e-9));
  const auto lastIndex = static_cast<long>(std::floor(to / reference.step + 1e-9));
  if (lastIndex - firstIndex < 8) throw SignalError("the runs have no length in common around the impact");
  for (long i = firstIndex; i <= lastIndex; ++i) result.axis.push_back(static_cast<double>(i) * reference.step);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Interpolator value(rows[r]);
    auto& row = result.values.emplace_back();
    for (const double x : result.axis) row.push_back(value(result.impact[r] + x));
  }
  // Correlation over what was compared.
  std::vector<std::size_t> compared;
  for (std::size_t i = 0; i < result.axis.size(); ++i)
    if (result.axis[i] >= -before && result.axis[i] <= after) compared.push_back(i);
  const auto part = [&](const std::vector<double>& row) {
    std::vector<double> values;
    for (const std::size_t i : compared) values.push_back(row[i]);
    return values;
  };
  for (const auto& row : result.values) result.correlation.push_back(correlationOf(part(result.values[0]), part(row)));
  for (std::size_t i = 0; i < result.axis.size(); ++i) {
    double sum = 0, low = result.values[0][i], high = low;
    for (const auto& row : result.values) {
      sum += row[i];
      low = std::min(low, row[i]);
      high = std::max(high, row[i]);
    }
    result.mean.push_back(sum / static_cast<double>(rows.size()));
    result.lowest.push_back(low);
    result.highest.push_back(high);
  }
  return result;
}

}  // namespace

void requireRisingPositions(const Passage& passage) {
  const std::string& name = passage.series.name;
  const auto& x = passage.position;
  if (x.size() != passage.series.values.size())
    throw SignalError("signal '" + name + "' has " + std::to_string(passage.series.values.size()) + " samples but " +
                      std::to_string(x.size()) + " positions");
  const auto fall = std::adjacent_find(x.begin(), x.end(), [](double now, double next) { return !(next > now); });
  if (fall == x.end()) return;
  const auto sample = static_cast<std::size_t>(fall - x.begin()) + 1;
  throw SignalError("signal '" + name + "': the position does not rise at sample " + std::to_string(sample), sample);
}

double timeAtPosition(const Passage& passage, double position) {
  const auto& x = passage.position;
  const auto above = std::upper_bound(x.begin(), x.end() - 1, position);
  const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - x.begin()));
  const double part = (position - x[k - 1]) / (x[k] - x[k - 1]);
  return passage.series.start + passage.series.step * (static_cast<double>(k - 1) + part);
}

double positionAtTime(const Passage& passage, double time) {
  const double last = static_cast<double>(passage.position.size() - 1);
  const double sample = std::clamp((time - passage.series.start) / passage.series.step, 0.0, last);
  const auto below = std::min(static_cast<std::size_t>(sample), passage.position.size() - 2);
  const double part = sample - static_cast<double>(below);
  return passage.position[below] + part * (passage.position[below + 1] - passage.position[below]);
}

Passage passageAtSpeed(TimeSeries series, double speed) {
  if (!(std::isfinite(speed) && speed > 0)) throw SignalError("the speed must be a positive number of m/s");
  Passage passage{std::move(series), {}};
  for (std::size_t i = 0; i < passage.series.values.size(); ++i)
    passage.position.push_back(speed * passage.series.step * static_cast<double>(i));
  return passage;
}

Passage passageAtSpeed(TimeSeries series, const std::vector<double>& speed) {
  if (speed.size() != series.values.size())
    throw SignalError("signal '" + series.name + "' has " + std::to_string(series.values.size()) + " samples but " +
                      std::to_string(speed.size()) + " speeds");
  Passage passage{std::move(series), {}};
  double position = 0;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (!(std::isfinite(speed[i]) && speed[i] > 0))
      throw SignalError("signal '" + passage.series.name + "': the speed at sample " + std::to_string(i) +
                            " is not a positive number",
                        i);
    if (i > 0) position += 0.5 * (speed[i - 1] + speed[i]) * passage.series.step;
    passage.position.push_back(position);
  }
  return passage;
}

double speedAt(const Passage& passage, double time, double half) {
  const auto& x = passage.position;
  if (x.size() < 2) throw SignalError("signal '" + passage.series.name + "' has no positions");
  const double sample = (time - passage.series.start) / passage.series.step;
  const auto centre = static_cast<std::size_t>(std::clamp(std::round(sample), 0.0, static_cast<double>(x.size() - 1)));
  const auto low = std::lower_bound(x.begin(), x.end(), x[centre] - half) - x.begin();
  const auto high = std::upper_bound(x.begin(), x.end(), x[centre] + half) - x.begin() - 1;
  const auto from = std::min(low, static_cast<std::ptrdiff_t>(x.size()) - 2), to = std::max(high, from + 1);
  return (x[static_cast<std::size_t>(to)] - x[static_cast<std::size_t>(from)]) /
         (static_cast<double>(to - from) * passage.series.step);
}

AlignedRuns alignInTime(const std::vector<Passage>& runs, const AlignmentOptions& options) {
  requirePassages(runs);
  std::vector<TimeSeries> rows;
  for (const auto& run : runs) {
    const bool same = std::abs(run.series.step - runs[0].series.step) <= 1e-9 * runs[0].series.step;
    rows.push_back(same ? run.series : resample(run.series, runs[0].series.step));
  }
  const double impact = options.anchor.value_or(anchorOf(runs[0]).time);
  const double speed = speedAt(runs[0], impact);
  AlignedRuns result = align(rows, impact, options.before / speed, options.after / speed, options.largestShift);
  for (std::size_t r = 0; r < runs.size(); ++r) result.speed.push_back(speedAt(runs[r], result.impact[r]));
  return result;
}

AlignedRuns alignInPosition(const std::vector<Passage>& runs, const AlignmentOptions& options) {
  requirePassages(runs);
  const auto& first = runs[0];
  const double step = (first.position.back() - first.position.front()) / static_cast<double>(first.position.size() - 1);
  std::vector<TimeSeries> rows;
  for (const auto& run : runs) rows.push_back(overPosition(run, step));
  AlignedRuns result = align(rows, positionAtTime(first, options.anchor.value_or(anchorOf(first).time)), options.before,
                             options.after, options.largestShift);
  result.inPosition = true;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& x = runs[r].position;
    const auto i = std::lower_bound(x.begin(), x.end(), result.impact[r]) - x.begin();
    result.speed.push_back(speedAt(runs[r], runs[r].series.timeAt(static_cast<std::size_t>(i))));
  }
  return result;
}

Dispersion dispersionOf(std::vector<double> values) {
  Dispersion result;
  result.values = std::move(values);
  const auto n = static_cast<double>(result.values.size());
  if (result.values.empty()) return result;
  result.mean = std::accumulate(result.values.begin(), result.values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : result.values) squares += (value - result.mean) * (value - result.mean);
  result.standardDeviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0.0;
  const auto [low, high] = std::minmax_element(result.values.begin(), result.values.end());
  result.range = result.mean != 0 ? (*high - *low) / result.mean : 0.0;
  return result;
}

RunDispersion runDispersion(const AlignedRuns& runs, const FeatureOptions& options) {
  std::vector<double> peaks, wavelengths;
  for (std::size_t r = 0; r < runs.values.size(); ++r) {
    const double speed = runs.speed[r];
    const double perMetre = runs.inPosition ? 1.0 : 1.0 / speed;
    double peak = 0;
    for (std::size_t i = 0; i < runs.axis.size(); ++i)
      if (runs.axis[i] >= -options.before * perMetre && runs.axis[i] <= options.after * perMetre)
        peak = std::max(peak, std::abs(runs.values[r][i]));
    peaks.push_back(peak);
    // Over time: a position axis is divided by the run's speed.
    const double perSecond = runs.inPosition ? 1.0 / speed : 1.0;
    TimeSeries series{runs.axis.front() * perSecond, (runs.axis[1] - runs.axis[0]) * perSecond, runs.values[r],
                      runs.names[r], ""};
    wavelengths.push_back(shows(series.rate(), options.waveBand)
                              ? wavelengthByCrossings(series, 0, options.waveSpan / speed, speed, options.waveBand)
                              : std::nan(""));
  }
  return {dispersionOf(peaks), dispersionOf(wavelengths)};
}

}  // namespace squat::signals
