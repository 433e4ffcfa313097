#include "records/SampleClock.h"

#include <algorithm>
#include <cmath>

#include "records/LostSamples.h"
#include "signals/Median.h"

namespace squat::records {
namespace {

std::vector<double> stepsBetween(const double* times, std::size_t count) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < count; ++i)
    if (std::isfinite(times[i]) && std::isfinite(times[i - 1])) steps.push_back(times[i] - times[i - 1]);
  return steps;
}

// The mean of the steps that are no gap: those near the median, as far as the resolution allows.
double meanStep(const std::vector<double>& steps, double median, double resolution) {
  double sum = 0, count = 0;
  for (const double step : steps)
    if (std::abs(step - median) <= 0.3 * std::abs(median) + 2 * resolution) {
      sum += step;
      count += 1;
    }
  return count > 0 ? sum / count : 0;
}

// Steps of a clock without losses.
ClockSteps stepsOfAll(const std::vector<double>& steps, double median) {
  ClockSteps result;
  std::vector<double> off(steps.size());
  std::transform(steps.begin(), steps.end(), off.begin(), [&](double step) { return std::abs(step - median); });
  const std::size_t gaps = std::max<std::size_t>(2, off.size() / 10000);
  const std::size_t rank = off.size() > gaps + 1 ? off.size() - 1 - gaps : 0;
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(rank), off.end());
  result.resolution = off[rank];
  result.step = std::max(0.0, meanStep(steps, median, result.resolution));
  if (result.step > 0)
    result.accuracy = 2 * result.resolution / (static_cast<double>(steps.size()) * result.step) + 1e-7;
  return result;
}

// The steps up to where a clock that runs evenly goes on at another rate; all of them where it does not. Even is what
// has nine in ten steps within 3 % of their median: jitter, rounding and lost samples do not change the rate.
std::vector<double> beforeOtherRate(std::vector<double> steps) {
  constexpr std::size_t window = 64;
  constexpr double alike = 0.03, share = 0.9;
  const auto evenStep = [&](std::size_t from) {
    std::vector<double> some(steps.begin() + static_cast<std::ptrdiff_t>(from),
                             steps.begin() + static_cast<std::ptrdiff_t>(from + window));
    const double median = signals::median(some);
    const auto near = std::count_if(some.begin(), some.end(),
                                    [&](double step) { return std::abs(step - median) <= alike * std::abs(median); });
    return static_cast<double>(near) >= share * static_cast<double>(window) ? median : 0.0;
  };
  if (steps.size() < 2 * window) return steps;
  const double first = evenStep(0);
  if (!(first > 0)) return steps;
  for (std::size_t from = window; from + window <= steps.size(); from += window)
    if (const double step = evenStep(from); step > 0 && std::abs(step / first - 1) > alike) {
      steps.resize(std::max(from - window, window / 2));  // the change may lie in the window before
      break;
    }
  return steps;
}

}  // namespace

ClockSteps stepsOf(const std::vector<double>& times) {
  auto steps = beforeOtherRate(stepsBetween(times.data(), times.size()));
  if (steps.empty()) return {};
  const double median = signals::median(steps);
  const bool loses = losesSamples(steps, median);
  if (loses) std::erase_if(steps, [median](double step) { return step >= 1.5 * median; });
  ClockSteps result = stepsOfAll(steps, median);
  result.losesSamples = loses;
  return result;
}

bool SampleClock::keeps(double deviation) const { return std::abs(deviation) <= 0.6 * steps_.step + steps_.resolution; }

bool SampleClock::fits(double step) const {
  return std::abs(step - steps_.step) <= 0.3 * steps_.step + 2 * steps_.resolution;
}

std::size_t SampleClock::window() const {
  const double wanted = 16 * steps_.resolution / steps_.step;
  return static_cast<std::size_t>(std::clamp(wanted, 64.0, 8192.0));
}

bool SampleClock::sameRate(const double* times, std::size_t count) const {
  const auto steps = stepsBetween(times, count);
  if (steps.size() < 3) return true;
  const double mean = meanStep(steps, signals::median(steps), steps_.resolution);
  const double rounding = 4 * steps_.resolution / (static_cast<double>(steps.size()) * steps_.step);
  return std::abs(mean / steps_.step - 1) <= std::max(1e-3, rounding);
}

}  // namespace squat::records
