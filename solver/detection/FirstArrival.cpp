#include "detection/FirstArrival.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace squat::detection {
namespace {

constexpr double windowAhead = 0.15, windowBehind = 0.1;  // [m] of the anchor
constexpr double quietStretch = 40e-3;                    // [s] ahead of that, of which the noise is taken
constexpr double meanStretch = 5e-3;  // [s] of the mean that is taken off: slower motion does not count
constexpr double beforeOnset = 0.5e-3, afterOnset = 1e-3;  // [s] of the onset
constexpr double onsetShare = 0.35,
                 onsetAboveNoise = 4;  // of the largest value; of the noise's root mean square: the onset
constexpr double largestShare = 0.9;   // where noise is as large as the event

std::size_t samplesOf(double seconds, double step) { return static_cast<std::size_t>(std::lround(seconds / step)); }

// Each value of [from, to) without the mean of those before it: a filter that brings nothing forward in time.
std::vector<double> withoutMeanBefore(const std::vector<double>& values, std::size_t from, std::size_t to,
                                      std::size_t before) {
  double sum = 0;
  for (std::size_t i = from - before; i < from; ++i) sum += values[i];
  std::vector<double> result;
  for (std::size_t i = from; i < to; ++i) {
    result.push_back(values[i] - sum / static_cast<double>(before));
    sum += values[i] - values[i - before];
  }
  return result;
}

double energyOf(const std::vector<double>& values, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += values[i] * values[i];
  return sum;
}

}  // namespace

std::optional<FirstArrival> firstArrival(const signals::TimeSeries& one, const signals::TimeSeries& other,
                                         std::size_t anchor, double speed) {
  const double step = one.step;
  const auto before = samplesOf(meanStretch, step), noiseSamples = samplesOf(quietStretch, step);
  const auto toAnchor = samplesOf(windowAhead / speed, step), fromAnchor = samplesOf(windowBehind / speed, step);
  const auto size = std::min(one.values.size(), other.values.size());
  if (before == 0 || anchor < before + noiseSamples + toAnchor || anchor + fromAnchor >= size) return std::nullopt;
  const std::size_t first = anchor - toAnchor - noiseSamples;
  const std::array boxes{withoutMeanBefore(one.values, first, anchor + fromAnchor, before),
                         withoutMeanBefore(other.values, first, anchor + fromAnchor, before)};
  std::array<double, 2> mean{};  // square of the noise
  for (std::size_t k = 0; k < 2; ++k) {
    mean[k] = energyOf(boxes[k], 0, noiseSamples) / static_cast<double>(noiseSamples);
    if (!(energyOf(boxes[k], 0, boxes[k].size()) > 0)) return std::nullopt;
  }
  const auto end = boxes[0].size();
  const auto larger = [&](std::size_t i) { return std::max(std::abs(boxes[0][i]), std::abs(boxes[1][i])); };
  double largest = 0;
  for (std::size_t i = noiseSamples; i < end; ++i) largest = std::max(largest, larger(i));
  const double level = std::min(std::max(onsetShare * largest, onsetAboveNoise * std::sqrt(std::max(mean[0], mean[1]))),
                                largestShare * largest);
  std::size_t onset = noiseSamples;
  while (larger(onset) < level) ++onset;
  const auto from = onset - std::min(onset, samplesOf(beforeOnset, step)),
             to = std::min(end, onset + samplesOf(afterOnset, step) + 1);
  FirstArrival arrival;
  for (std::size_t k = 0; k < 2; ++k) {
    arrival.energy[k] = step * energyOf(boxes[k], from, to);
    arrival.noise[k] = step * mean[k] * static_cast<double>(to - from);
  }
  return arrival;
}

}  // namespace squat::detection
