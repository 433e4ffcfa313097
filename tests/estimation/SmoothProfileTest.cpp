// The spline through the knots against closed forms.
#include "estimation/SmoothProfile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace squat::estimation {
namespace {

// A quartic that is level and at rest at both ends, (1 - u^2)^2: a cubic spline with those end conditions has an error
// of at most 5/384 h^4 times its fourth derivative, here 24 / L^4 (Hall and Meyer, J. Approx. Theory 16, 1976).
TEST(SmoothProfile, ComesAsNearAsASplineCan) {
  constexpr double half = 0.03, depth = 1e-4;
  const SmoothProfile profile(-half, half, 0.005);
  ASSERT_EQ(profile.unknowns(), 11);
  const auto height = [&](double x) { return -depth * std::pow(1 - std::pow(x / half, 2), 2); };
  Eigen::VectorXd heights(11);
  for (Eigen::Index k = 0; k < 11; ++k) heights[k] = height(profile.knots()[static_cast<std::size_t>(k) + 1]);
  const double bound = 5.0 / 384 * std::pow(0.005, 4) * 24 * depth / std::pow(half, 4);
  for (const auto& point : profile.points(heights)) EXPECT_NEAR(point.height, height(point.position), bound);
  // The fit is no worse than the heights themselves, and near them.
  const auto fitted = profile.fit(height);
  EXPECT_NEAR((fitted - heights).cwiseAbs().maxCoeff(), 0, bound);
}

TEST(SmoothProfile, EndsLevelAndAtRest) {
  const SmoothProfile profile(-0.02, 0.03, 0.006);
  const auto points = profile.points(Eigen::VectorXd::Constant(profile.unknowns(), -5e-5));
  EXPECT_EQ(points.front().height, 0);
  EXPECT_EQ(points.back().height, 0);
  // At rest: the first millimetre holds a sixth of what a straight line to the next knot would.
  EXPECT_LT(std::abs(points[1].height), 5e-5 / 6 / 3);
}

// Second derivatives of that quartic at the knots: -depth (12 u^2 - 4) / L^2, to the order of the spline (h^2).
TEST(SmoothProfile, KnowsItsCurvature) {
  constexpr double half = 0.03, depth = 1e-4;
  const SmoothProfile profile(-half, half, 0.003);
  Eigen::VectorXd heights(profile.unknowns());
  for (Eigen::Index k = 0; k < heights.size(); ++k)
    heights[k] = -depth * std::pow(1 - std::pow(profile.knots()[static_cast<std::size_t>(k) + 1] / half, 2), 2);
  const Eigen::VectorXd curvature = profile.curvature() * heights;
  const double greatest = 8 * depth / (half * half);  // at the ends
  for (Eigen::Index k = 0; k < curvature.size(); ++k) {
    const double u = profile.knots()[static_cast<std::size_t>(k)] / half;
    EXPECT_NEAR(curvature[k], -depth * (12 * u * u - 4) / (half * half), 0.03 * greatest) << u;
  }
}

}  // namespace
}  // namespace squat::estimation
