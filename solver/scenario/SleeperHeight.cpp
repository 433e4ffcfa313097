#include "scenario/SleeperHeight.h"

#include <algorithm>
#include <cmath>

namespace squat::scenario {

namespace {

// What the middle lacks, as a share of what it lacks at the centre: 1 up to `from`, 0 beyond `to`, straight in between.
// As a sum of two ramps: (max(0, to - y) - max(0, from - y)) / (to - from).
struct Missing {
  double from, to;

  // Integrated once and twice from far outside: minus the area beyond y, and what that integrates to.
  double once(double y) const { return -ramps(y, 2) / 2; }
  double twice(double y) const { return ramps(y, 3) / 6; }

 private:
  double ramps(double y, int power) const {
    return (std::pow(std::max(0.0, to - y), power) - std::pow(std::max(0.0, from - y), power)) / (to - from);
  }
};

// Mean over the station's own shape function, by parts: on the right of the station c the integral of
// (r - y) / (r - c) m(y) is (twice(r) - twice(c)) / (r - c) - once(c), on its left likewise.
double meanAbout(const Missing& missing, const std::vector<double>& at, std::size_t i) {
  double integral = 0, length = 0;
  if (i + 1 < at.size()) {
    const double own = at[i + 1] - at[i];
    integral += (missing.twice(at[i + 1]) - missing.twice(at[i])) / own - missing.once(at[i]);
    length += own / 2;
  }
  if (i > 0) {
    const double own = at[i] - at[i - 1];
    integral += missing.once(at[i]) - (missing.twice(at[i]) - missing.twice(at[i - 1])) / own;
    length += own / 2;
  }
  return integral / length;
}

}  // namespace

std::vector<double> sleeperHeightShares(const Inputs& inputs, const std::vector<double>& distances) {
  const auto& sleeper = inputs.sleeper;
  if (sleeper.middleHeight == 0 || sleeper.middleHeight == sleeper.height) return {};
  const double lacking = 1 - sleeper.middleHeight / sleeper.height;
  const Missing missing{sleeper.middleHalfLength, fullHeightFrom(inputs)};
  std::vector<double> shares;
  for (std::size_t i = 0; i < distances.size(); ++i) shares.push_back(1 - lacking * meanAbout(missing, distances, i));
  return shares;
}

}  // namespace squat::scenario
