// Dips and waves of profiles that are known in closed form.
#include "growth/Shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace squat::growth {
namespace {

std::vector<double> places(double from, double to, double step) {
  std::vector<double> x;
  for (double at = from; at <= to + 1e-9; at += step) x.push_back(at);
  return x;
}

// -d (1 - (x/a)^2): 5 % of the depth stands at x = a sqrt(0.95). Between points 1 mm apart the chord is off the
// parabola by d (h/a)^2 / 4, which its slope turns into some 0.01 mm.
TEST(GrowthShape, DipOfAParabola) {
  const auto x = places(-0.05, 0.05, 0.001);
  std::vector<double> height;
  for (const double at : x) height.push_back(std::min(0.0, -2e-4 * (1 - std::pow((at - 0.004) / 0.02, 2))));
  const Dip dip = dipOf(x, height);
  EXPECT_NEAR(dip.depth, 2e-4, 1e-12);
  EXPECT_NEAR(dip.place, 0.004, 1e-12);
  EXPECT_NEAR(dip.length, 2 * 0.02 * std::sqrt(0.95), 2e-5);
}

TEST(GrowthShape, ASmoothRailHasNoDip) {
  const auto x = places(0, 0.1, 0.005);
  const Dip dip = dipOf(x, std::vector<double>(x.size(), 0.0));
  EXPECT_EQ(dip.depth, 0);
  EXPECT_EQ(dip.length, 0);
}

// A sine of 8 um from crest to valley on a sloping line: the Hann window over 120 mm leaves the height of a wave that
// fits in four times as it is, within the 2 % that its neighbours leak, and its length within the step of the search
// and the 0.5 mm by which the cut ends pull it.
TEST(GrowthShape, TheStrongestWaveIsFound) {
  const auto x = places(0, 0.120, 0.0026);
  std::vector<double> height;
  for (const double at : x)
    height.push_back(4e-6 * std::sin(2 * std::numbers::pi * at / 0.030 + 0.7) + 1e-3 * at - 5e-5);
  const Wave wave = strongestWave(waveSpectrum(x, height, 0, 0.120));
  EXPECT_NEAR(wave.length, 0.030, 0.001);
  EXPECT_NEAR(wave.height, 8e-6, 0.16e-6);
}

// Stations of two lengths: each counts with its share of the way. Without, the part with short stations would count
// twice.
TEST(GrowthShape, UnequalStationsCountWithTheirLength) {
  auto x = places(0, 0.060, 0.0025);
  const auto rest = places(0.065, 0.120, 0.005);
  x.insert(x.end(), rest.begin(), rest.end());
  std::vector<double> height;
  for (const double at : x) height.push_back(5e-6 * std::cos(2 * std::numbers::pi * at / 0.040));
  const Wave wave = strongestWave(waveSpectrum(x, height, 0, 0.120));
  EXPECT_NEAR(wave.length, 0.040, 0.001);
  EXPECT_NEAR(wave.height, 1e-5, 0.3e-6);
}

TEST(GrowthShape, NoWaveInALine) {
  const auto x = places(0, 0.120, 0.0026);
  std::vector<double> height;
  for (const double at : x) height.push_back(1e-3 * at);
  EXPECT_LT(strongestWave(waveSpectrum(x, height, 0, 0.120)).height, 1e-15);
  EXPECT_TRUE(waveSpectrum(x, height, 0.1, 0.1001).length.empty());
}

}  // namespace
}  // namespace squat::growth
