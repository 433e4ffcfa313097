// solver/estimation/ProfileBounds.h - how well each height is known, and with it depth and length.
#pragma once

#include <vector>

#include "estimation/Estimation.h"
#include "estimation/LeastSquares.h"
#include "estimation/SmoothProfile.h"

namespace squat::estimation {

// Pointwise intervals of 90 % from the distribution of the heights, positions from the deepest sample. Stretches over
// which a wheel of `radius` [m] passes without touching, or that are curved so much that the bounds allow it, are not
// felt. The first unknowns of the solution are the heights.
std::vector<ProfileSample> profileWithBounds(const SmoothProfile& profile, const LinearSolution& solution,
                                             double radius);

// Depth and length over profiles drawn from the same distribution, seeded; the values are those of the estimate.
struct Extent {
  Interval depth, length;
};
Extent extentOf(const SmoothProfile& profile, const LinearSolution& solution);

// Depth of a profile, and its length around the deepest sample between 5 % of it [m].
double depthOf(const Eigen::VectorXd& samples);
double lengthOf(const Eigen::VectorXd& samples, const std::vector<double>& positions);

}  // namespace squat::estimation
