// solver/detection/SizeTrend.h - how length and depth of a squat go with what is measured, on the average of the
// examples.
#pragma once

#include <array>
#include <vector>

#include "detection/Example.h"

namespace squat::detection {

// The logarithms of length and depth as linear functions of the logarithms of the bands' energies by the square of the
// speed, and of the speed: ridge regression over the examples that are squats. Without ten of them, or for an event
// whose record does not show all bands, there is no trend.
class SizeTrend {
 public:
  SizeTrend() = default;
  explicit SizeTrend(const std::vector<Example>& examples);

  struct Factors {
    double length = 1, depth = 1;
  };
  // What the sizes of the example are multiplied by to be those of the event; at most a factor of e either way.
  Factors factors(const Example& example, const EventFeatures& event) const;

 private:
  static constexpr std::size_t inputs = bandCount + 1;
  using Weights = std::array<double, inputs>;
  Weights length_{}, depth_{};
  bool isKnown_ = false;
};

}  // namespace squat::detection
