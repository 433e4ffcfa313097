// Bounds of a linear model whose covariance is known, and what a wheel does not touch.
#include "estimation/ProfileBounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace squat::estimation {
namespace {

constexpr double kRadius = 0.46;  // [m]

LinearSolution dipWith(const SmoothProfile& profile, double depth, double deviation) {
  LinearSolution solution;
  solution.unknowns = profile.fit([&](double x) { return -0.5 * depth * (1 + std::cos(x / 0.03 * M_PI)); });
  solution.covariance = deviation * deviation * Eigen::MatrixXd::Identity(profile.unknowns(), profile.unknowns());
  return solution;
}

// At a knot the curve is its own height: half the interval is 1.645 deviations, between knots the spline mixes both.
TEST(ProfileBounds, AreThoseOfTheCovariance) {
  const SmoothProfile profile(-0.03, 0.03, 0.006);  // the samples hit the knots
  constexpr double deviation = 4e-6;
  const auto samples = profileWithBounds(profile, dipWith(profile, 1e-4, deviation), kRadius);
  ASSERT_EQ(samples.size(), profile.positions().size());
  for (std::size_t i = 6; i + 6 < samples.size(); i += 6) {
    EXPECT_NEAR(samples[i].upper - samples[i].height, 1.645 * deviation, 1e-9);  // rounding
    EXPECT_NEAR(samples[i].height - samples[i].lower, 1.645 * deviation, 1e-9);
  }
  EXPECT_EQ(samples.front().lower, samples.front().upper);  // no defect there
  EXPECT_EQ(samples[30].position, 0);                       // the deepest
  EXPECT_NEAR(samples[30].height, -1e-4, 1e-7);             // the spline through 11 knots
}

// One height that is uncertain: the depth is normal with its deviation; 90 % of 2000 draws, whose own quantiles scatter
// by 4 % of the deviation.
TEST(ProfileBounds, DepthAndLengthAreDrawn) {
  const SmoothProfile profile(-0.03, 0.03, 0.006);
  auto solution = dipWith(profile, 1e-4, 0);
  solution.covariance.setZero();
  solution.covariance(4, 4) = 4e-12;  // the middle one, 2 um
  for (Eigen::Index i = 0; i < solution.covariance.rows(); ++i) solution.covariance(i, i) += 1e-24;
  const auto extent = extentOf(profile, solution);
  EXPECT_NEAR(extent.depth.value, 1e-4, 1e-7);
  EXPECT_NEAR(extent.depth.low, 1e-4 - 1.645 * 2e-6, 0.4e-6);
  EXPECT_NEAR(extent.depth.high, 1e-4 + 1.645 * 2e-6, 0.4e-6);
  // Cosine: 5 % of the depth is left where 1 + cos(pi x / 0.03) = 0.1, at 25.7 mm; samples stand 1 mm apart.
  EXPECT_NEAR(extent.length.value, 2 * 0.0257, 0.0015);
}

// A wheel of 0.46 m bridges a gap of 20 mm whose middle is deeper than 10^2 / 920 = 0.109 mm; it follows a dip of 60 mm
// that is 0.1 mm deep, whose curvature is a quarter of its own.
TEST(ProfileBounds, WhatTheWheelBridgesIsMarked) {
  const SmoothProfile profile(-0.03, 0.03, 0.004);
  auto solution = dipWith(profile, 1e-4, 1e-6);
  for (const auto& sample : profileWithBounds(profile, solution, kRadius))
    EXPECT_TRUE(sample.isFelt) << sample.position;
  solution.unknowns =
      profile.fit([](double x) { return std::abs(x) < 0.010 ? -2e-4 * (1 + std::cos(x / 0.010 * M_PI)) : 0.0; });
  const auto samples = profileWithBounds(profile, solution, kRadius);
  const auto deepest = std::min_element(samples.begin(), samples.end(),
                                        [](const auto& a, const auto& b) { return a.height < b.height; });
  EXPECT_FALSE(deepest->isFelt);
  EXPECT_TRUE(samples.front().isFelt);
  EXPECT_TRUE(samples.back().isFelt);
}

}  // namespace
}  // namespace squat::estimation
