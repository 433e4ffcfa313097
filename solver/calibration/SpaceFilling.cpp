#include "calibration/SpaceFilling.h"

#include <cmath>

namespace squat::calibration {

std::vector<double> spaceFillingPoint(std::size_t index, std::size_t dimensions) {
  constexpr int iterations = 60;  // of a contraction by at least 2
  double g = 2;
  for (int i = 0; i < iterations; ++i) g = std::pow(1 + g, 1.0 / static_cast<double>(dimensions + 1));
  std::vector<double> point(dimensions);
  double step = 1;
  for (auto& coordinate : point) {
    step /= g;
    coordinate = std::fmod(0.5 + step * static_cast<double>(index + 1), 1.0);
  }
  return point;
}

}  // namespace squat::calibration
