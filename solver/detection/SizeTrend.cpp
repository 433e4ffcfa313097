#include "detection/SizeTrend.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace squat::detection {
namespace {

constexpr std::size_t fewest = 10;
constexpr double ridge = 0.3;  // of the sum of squares: found by leaving out one vehicle after the other

using Inputs = std::array<double, bandCount + 1>;

Inputs inputsOf(const std::array<double, bandCount>& energy, double speed) {
  Inputs inputs{};
  for (std::size_t b = 0; b < bandCount; ++b) inputs[b] = std::log10(std::max(energy[b], 1e-12) / (speed * speed));
  inputs[bandCount] = std::log(speed);
  return inputs;
}

bool hasSize(const Example& example) { return example.kind == Kind::squat && example.length > 0 && example.depth > 0; }

}  // namespace

SizeTrend::SizeTrend(const std::vector<Example>& examples) {
  const auto count = std::count_if(examples.begin(), examples.end(), hasSize);
  if (static_cast<std::size_t>(count) < fewest) return;
  Eigen::MatrixXd x(count, static_cast<Eigen::Index>(inputs));
  Eigen::MatrixXd y(count, 2);
  Eigen::Index row = 0;
  for (const auto& example : examples) {
    if (!hasSize(example)) continue;
    const auto own = inputsOf(example.energy, example.speed);
    for (std::size_t i = 0; i < inputs; ++i) x(row, static_cast<Eigen::Index>(i)) = own[i];
    y(row, 0) = std::log(example.length), y(row, 1) = std::log(example.depth);
    ++row;
  }
  // Means taken off, so that the constant is not held down by the ridge.
  x.rowwise() -= x.colwise().mean().eval();
  y.rowwise() -= y.colwise().mean().eval();
  Eigen::MatrixXd normal = x.transpose() * x;
  normal.diagonal().array() += ridge;
  const Eigen::MatrixXd weights = normal.ldlt().solve(x.transpose() * y);
  for (std::size_t i = 0; i < inputs; ++i) {
    length_[i] = weights(static_cast<Eigen::Index>(i), 0);
    depth_[i] = weights(static_cast<Eigen::Index>(i), 1);
  }
  isKnown_ = true;
}

SizeTrend::Factors SizeTrend::factors(const Example& example, const EventFeatures& event) const {
  if (!isKnown_ || std::count(event.freedom.begin(), event.freedom.end(), 0.0) > 0) return {};
  std::array<double, bandCount> signal{};
  for (std::size_t b = 0; b < bandCount; ++b) {
    // Below a tenth of the noise nothing is measured: the example's own energy stands there.
    const double above = event.energy[b] - event.noise[b];
    const double scaled = example.energy[b] * event.speed * event.speed / (example.speed * example.speed);
    signal[b] = above > 0.1 * event.noise[b] ? above : scaled;
  }
  const auto here = inputsOf(signal, event.speed), there = inputsOf(example.energy, example.speed);
  double length = 0, depth = 0;
  for (std::size_t i = 0; i < inputs; ++i) {
    length += length_[i] * (here[i] - there[i]);
    depth += depth_[i] * (here[i] - there[i]);
  }
  return {std::exp(std::clamp(length, -1.0, 1.0)), std::exp(std::clamp(depth, -1.0, 1.0))};
}

}  // namespace squat::detection
