#include "detection/PathSpectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenario/DefectSurface.h"
#include "signals/FourierTransform.h"

namespace squat::detection {
namespace {

constexpr double wheelRadius = 0.46;  // [m]
constexpr double pathStep = 0.5e-3;   // [m]: the shortest waves that count are 8 mm, 16 m/s at 2 kHz
constexpr std::size_t pathPoints = 4096;

// Path of the wheel over heights sampled at pathStep: as scenario::rigidWheelPath(), with the parabola s^2 / 2R for the
// circle (0.1 % off at its edge) and the heights of the samples alone, thirty times as fast for a thousand defects.
std::vector<double> pathOver(const std::vector<double>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double reach = std::sqrt(2 * wheelRadius * (*high - *low));
  std::vector<double> gaps;  // of the wheel above its lowest point
  for (double s = 0; s <= reach + pathStep; s += pathStep) gaps.push_back(s * s / (2 * wheelRadius));
  std::vector<double> path = heights;
  for (std::size_t i = 0; i < path.size(); ++i)
    for (std::size_t k = 1; k < gaps.size(); ++k) {
      if (k <= i) path[i] = std::max(path[i], heights[i - k] - gaps[k]);
      if (i + k < heights.size()) path[i] = std::max(path[i], heights[i + k] - gaps[k]);
    }
  return path;
}

}  // namespace

PathSpectrum::PathSpectrum(const scenario::Defect& defect) : step_(1 / (pathStep * pathPoints)) {
  constexpr double margin = 0.03;  // [m] on both sides: a wheel feels a hump of 1 mm from there
  auto path = pathOver(scenario::defectHeights(defect, margin, pathStep));
  path.resize(pathPoints, 0.0);
  std::vector<signals::Complex> spectrum(pathPoints / 2 + 1);
  static const signals::RealTransform transform(pathPoints);  // planning costs more than a transform
  transform.forward(path.data(), spectrum.data());
  sum_.assign(1, 0.0);
  for (std::size_t k = 0; k + 1 < spectrum.size(); ++k) {
    const double angular = 2 * std::numbers::pi * step_ * static_cast<double>(k);
    const double second = std::abs(spectrum[k]) * pathStep * angular * angular;
    sum_.push_back(sum_.back() + 2 * second * second * step_);
  }
}

double PathSpectrum::energy(double speed, double low, double high) const {
  return speed * speed * speed * std::max(0.0, upTo(high / speed) - upTo(low / speed));
}

double PathSpectrum::upTo(double wavenumber) const {
  // Each value stands for a step around its own wavenumber.
  const double at = std::clamp(wavenumber / step_ + 0.5, 0.0, static_cast<double>(sum_.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(at), sum_.size() - 2);
  return std::lerp(sum_[below], sum_[below + 1], at - static_cast<double>(below));
}

}  // namespace squat::detection
