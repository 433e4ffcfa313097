// Heights as levels, against what is known of sines and of chi-square.
#include "roughness/HeightSpectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::roughness {
namespace {

TEST(WavelengthBands, AreThirdOctaves) {
  const auto bands = wavelengthBands(0.01, 0.315);
  ASSERT_EQ(bands.size(), 16u);
  EXPECT_NEAR(bands.front().middle, 0.01, 1e-15);
  EXPECT_NEAR(bands.back().middle, 0.31623, 1e-5);
  for (std::size_t i = 1; i < bands.size(); ++i) EXPECT_NEAR(bands[i].shortest, bands[i - 1].longest, 1e-15);
}

// 20 lg(A / sqrt 2 / 1 um) in the sine's own band. Hann's main lobe, four lines of 0.2 1/m, lies within the band, 5.8
// 1/m wide, and its side lobes fall below -31 dB: 0.02 dB within, and bands a third octave away 25 dB lower.
TEST(HeightLevels, OfASine) {
  constexpr double wavelength = 0.04, amplitude = 20e-6, spacing = 0.001;
  std::vector<double> heights;
  for (int i = 0; i < 5000; ++i)
    heights.push_back(3e-4 + 1e-4 * i * spacing + amplitude * std::sin(2 * M_PI / wavelength * i * spacing + 0.3));
  const auto bands = wavelengthBands(0.01, 0.4);
  const auto levels = heightLevels(heights, spacing, bands);
  const double expected = 20 * std::log10(amplitude / std::sqrt(2.0) / 1e-6);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (std::abs(bands[i].middle / wavelength - 1) < 0.05)
      EXPECT_NEAR(levels[i], expected, 0.02);
    else
      EXPECT_LT(levels[i], expected - 25) << bands[i].middle;
  }
}

// Two in one band add up, in different bands they do not.
TEST(HeightLevels, SinesAddUpWithinABand) {
  constexpr double spacing = 0.0005;
  std::vector<double> heights;
  for (int i = 0; i < 20000; ++i) {
    const double x = i * spacing;
    heights.push_back(1e-6 * std::sin(2 * M_PI * x / 0.0485) + 2e-6 * std::cos(2 * M_PI * x / 0.0515) +
                      1e-6 * std::sin(2 * M_PI * x / 0.1));
  }
  const auto levels = heightLevels(heights, spacing, wavelengthBands(0.05, 0.1));
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_NEAR(levels[0], 10 * std::log10(2.5), 0.02);
  EXPECT_NEAR(levels[3], 10 * std::log10(0.5), 0.02);
}

TEST(HeightLevels, EndWhereTheSamplesDo) {
  EXPECT_TRUE(std::isnan(
      heightLevels(std::vector<double>{0, 1, 0, -1, 0, 1, 0, 2, 3, 1}, 0.01, wavelengthBands(0.01, 0.01))[0]));
}

// Quantiles of chi-square, 2.5 and 97.5 %, from tables: 10 degrees 3.247 and 20.483, 100 degrees 74.222 and 129.561.
TEST(CountSpread, IsThatOfChiSquare) {
  EXPECT_NEAR(countSpread(10).below, 10 * std::log10(2.0483), 0.05);
  EXPECT_NEAR(countSpread(10).above, -10 * std::log10(0.3247), 0.05);
  EXPECT_NEAR(countSpread(100).below, 10 * std::log10(1.29561), 0.01);
  EXPECT_NEAR(countSpread(100).above, -10 * std::log10(0.74222), 0.01);
}

}  // namespace
}  // namespace squat::roughness
