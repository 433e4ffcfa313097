// solver/simulation/VonMises.h - the equivalent stress of von Mises.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace squat::simulation {

// Of the stress xx, yy, zz, xy, yz, zx (in any order of the three shears), in the unit of the stress.
inline double vonMises(const Eigen::Matrix<double, 6, 1>& s) {
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace squat::simulation
