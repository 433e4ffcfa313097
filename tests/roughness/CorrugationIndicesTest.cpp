// Corrugation indices of sines.
#include "roughness/CorrugationIndices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::roughness {
namespace {

constexpr double sampleSpacing = 0.002;  // [m]

// Root mean square of a sine is A / sqrt 2, in every window of whole waves; windows of 5 upper limits hold 8 to 15
// waves, and what is no whole wave is at most a quarter of a wave's square: 3 %.
TEST(CorrugationIndices, OfASineStandInItsBand) {
  for (const auto& [wavelength, own] : {std::pair{0.018, 0}, {0.055, 1}, {0.17, 2}, {0.55, 3}}) {
    std::vector<double> heights;
    for (int i = 0; i < 30000; ++i) heights.push_back(1e-5 * std::sin(2 * M_PI * i * sampleSpacing / wavelength));
    const auto indices = corrugationIndices(heights, sampleSpacing);
    ASSERT_EQ(indices.size(), 4u);
    for (int b = 0; b < 4; ++b) {
      const auto& index = indices[static_cast<std::size_t>(b)];
      const double expected = b == own ? 1e-5 / std::sqrt(2.0) : 0;
      EXPECT_NEAR(index.rms, expected, 0.02e-5) << b;
      EXPECT_NEAR(index.typical, expected, 0.03e-5) << b;
      EXPECT_GT(index.windows, 20u);
    }
  }
}

// Five metres of corrugation in sixty: the largest window lies there.
TEST(CorrugationIndices, FindWhereItIsLargest) {
  std::vector<double> heights;
  for (int i = 0; i < 30000; ++i) {
    const double x = i * sampleSpacing;
    heights.push_back((x > 40 && x < 45 ? 5e-5 : 1e-6) * std::sin(2 * M_PI * x / 0.05));
  }
  const auto index = corrugationIndices(heights, sampleSpacing)[1];
  EXPECT_NEAR(index.largest, 5e-5 / std::sqrt(2.0), 0.1e-5);
  EXPECT_GT(index.largestAt, 40);
  EXPECT_LT(index.largestAt, 45);
  EXPECT_NEAR(index.typical, 1e-6 / std::sqrt(2.0), 0.05e-6);
  EXPECT_NEAR(index.exceeded, 5e-5 / std::sqrt(2.0), 0.1e-5) << "a twelfth of the way";
}

// Half of the power at each limit; neighbours add up to all of it.
TEST(CorrugationBands, ShareWhatLiesAtTheirLimits) {
  const auto& bands = corrugationBands();
  for (std::size_t b = 1; b < bands.size(); ++b)
    for (const double wavelength : {0.95, 1.0, 1.04}) {
      const double at = wavelength * bands[b].shortest;
      EXPECT_NEAR(std::pow(passedByBand(bands[b - 1], at), 2) + std::pow(passedByBand(bands[b], at), 2), 1, 1e-12);
    }
  EXPECT_NEAR(std::pow(passedByBand(bands[1], 0.03), 2), 0.5, 1e-12);
  EXPECT_EQ(passedByBand(bands[1], 0.2), 0);
}

TEST(CorrugationGauge, DoesNotReachAcrossAGap) {
  CorrugationGauge gauge(corrugationBands()[0]);
  for (int piece = 0; piece < 2; ++piece) {
    for (int i = 0; i < 60; ++i) gauge.add(1e-6, sampleSpacing);  // 0.12 m, less than a window of 0.15 m
    gauge.skip(0.1);
  }
  EXPECT_EQ(gauge.index().windows, 0u);
  EXPECT_TRUE(std::isnan(gauge.index().largest));
  EXPECT_NEAR(gauge.index().rms, 1e-6, 1e-15);
}

}  // namespace
}  // namespace squat::roughness
