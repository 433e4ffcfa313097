// Bands of IEC 61260-1:2014 and their levels.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "signals/SignalError.h"
#include "signals/ThirdOctaves.h"

namespace squat::signals {
namespace {

// One-third octaves from 25 Hz to 20 kHz: nominal frequencies from memory of the standard's table, unverified, and
// 10^(n/10) Hz rounded to five digits.
constexpr double table[][2] = {{25, 25.119},   {31.5, 31.623}, {40, 39.811},   {50, 50.119},   {63, 63.096},
                               {80, 79.433},   {100, 100},     {125, 125.89},  {160, 158.49},  {200, 199.53},
                               {250, 251.19},  {315, 316.23},  {400, 398.11},  {500, 501.19},  {630, 630.96},
                               {800, 794.33},  {1000, 1000},   {1250, 1258.9}, {1600, 1584.9}, {2000, 1995.3},
                               {2500, 2511.9}, {3150, 3162.3}, {4000, 3981.1}, {5000, 5011.9}, {6300, 6309.6},
                               {8000, 7943.3}, {10000, 10000}, {12500, 12589}, {16000, 15849}, {20000, 19953}};

TEST(ThirdOctaves, areThoseOfTheStandard) {
  const auto bands = thirdOctaveBands(22, 22500);
  ASSERT_EQ(bands.size(), std::size(table));
  for (std::size_t i = 0; i < bands.size(); ++i) {
    EXPECT_NEAR(bands[i].nominal, table[i][0], 1e-9 * table[i][0]);  // a round number, times a power of ten
    EXPECT_NEAR(bands[i].middle, table[i][1], 5e-5 * table[i][1]);   // five digits
    EXPECT_NEAR(bands[i].highest / bands[i].lowest, 1.2589, 5e-5);   // G^(1/3), five digits
    EXPECT_NEAR(std::sqrt(bands[i].highest * bands[i].lowest), bands[i].middle, 1e-9 * bands[i].middle);
    if (i > 0) {
      EXPECT_NEAR(bands[i].lowest, bands[i - 1].highest, 1e-9 * bands[i].lowest) << "a gap or an overlap";
    }
  }
}

TEST(ThirdOctaves, lieWithinTheLimitsAsAWhole) {
  // 891.25 to 1122.0 Hz are the edges of the band at 1 kHz.
  ASSERT_EQ(thirdOctaveBands(891, 1123).size(), 1u);
  EXPECT_EQ(thirdOctaveBands(891, 1123).front().nominal, 1000);
  EXPECT_TRUE(thirdOctaveBands(892, 1123).empty());
  EXPECT_TRUE(thirdOctaveBands(891, 1121).empty());
  EXPECT_THROW(thirdOctaveBands(0, 1000), SignalError);
  EXPECT_THROW(thirdOctaveBands(100, INFINITY), SignalError);
  EXPECT_TRUE(thirdOctaveBands(2000, 100).empty());
}

// White noise of density S has S (f2 - f1) in a band.
TEST(ThirdOctaves, aFlatSpectrumRisesByOneDecibelABand) {
  PowerSpectrum flat;
  constexpr double density = 0.02;
  for (int i = 0; i <= 5000; ++i) flat.frequency.push_back(i), flat.density.push_back(density);
  const auto bands = thirdOctaveBands(100, 3000);
  const auto levels = bandLevels(flat, bands);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double width = bands[i].middle * (std::pow(10, 0.05) - std::pow(10, -0.05));
    EXPECT_NEAR(levels[i], 10 * std::log10(density * width / 1e-12), 1e-9);  // exact for a linear density
    if (i > 0) {
      EXPECT_NEAR(levels[i] - levels[i - 1], 1, 1e-9);  // ten bands a decade
    }
  }
}

// A tone of amplitude a has the level 20 log10(a / sqrt(2) / 1e-6) in its band. Of a spectrum under a Hann window of
// half a second all but a thousandth lies within the band (2 Hz of 230 around 1 kHz).
TEST(ThirdOctaves, aToneHasItsLevelInItsBand) {
  TimeSeries tone;
  tone.step = 1e-4;
  constexpr double amplitude = 50;
  for (int i = 0; i < 5000; ++i) tone.values.push_back(amplitude * std::sin(2 * std::numbers::pi * 1020 * 1e-4 * i));
  const auto bands = thirdOctaveBands(800, 1300);
  ASSERT_EQ(bands.size(), 1u);
  const auto levels = bandLevels(powerSpectrum(tone), bands);
  EXPECT_NEAR(levels[0], 20 * std::log10(amplitude / std::sqrt(2) / 1e-6), 0.01);
}

}  // namespace
}  // namespace squat::signals
