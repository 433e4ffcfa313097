// Corrugation that is longer than the window of the local level.
#include "detection/WavyStretches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/Monitor.h"
#include "detection/Detect.h"
#include "detection/RecordMaker.h"

namespace squat::detection {
namespace {

constexpr double rate = 5000, speed = 20;

std::vector<WavyStretch> stretchesOf(std::vector<double> values) {
  MemoryStream stream(std::move(values), rate, speed, 1 << 16);
  Monitor monitor;
  return findCandidates(stream, {}, monitor).channels[0].waves;
}

// 40 m of waves of 60 mm, 333 Hz at 20 m/s: an amplitude of 3 in noise of 1.5, two thirds of all power.
TEST(WavyStretches, HavePlaceLengthAndWavelength) {
  auto values = normalNoise(static_cast<std::size_t>(10 * rate), 1.5, 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = speed * static_cast<double>(i) / rate;
    if (x > 80 && x < 120) values[i] += 3 * std::sin(2 * std::numbers::pi * x / 0.06);
  }
  const auto found = stretchesOf(std::move(values));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].wavelength, 0.06, 0.002);
  EXPECT_NEAR(found[0].from, 80, 12) << "pieces of 8 m, windows of 16";
  EXPECT_NEAR(found[0].to, 120, 12);
  EXPECT_GT(found[0].share, 0.5);
}

TEST(WavyStretches, NoiseHasNone) {
  EXPECT_TRUE(stretchesOf(normalNoise(static_cast<std::size_t>(20 * rate), 2, 5)).empty());
}

// A flat of a wheel of 0.92 m rings at 300 and 1000 Hz once in 2.89 m: narrow in frequency, but not there all the time.
TEST(WavyStretches, ImpactsThatRepeatAreNone) {
  auto values = normalNoise(static_cast<std::size_t>(10 * rate), 0.2, 6);
  for (double x = 20; x < 180; x += 2.89) addImpact(values, rate, x / speed, 40);
  EXPECT_TRUE(stretchesOf(std::move(values)).empty());
}

// A resonance at 400 Hz while the train speeds up from 15 to 20 m/s: what looks like one wavelength is so over a speed
// that varies by the 15 % which are one wavelength, and no more. Waves of 50 mm are one stretch at any speed.
TEST(WavyStretches, AResonanceDoesNotKeepItsWavelength) {
  std::vector<WavyStretch> resonance, waves;
  for (int i = 0; i < 60; ++i) {
    const double own = 15 + 5.0 * i / 59, from = 8.0 * i, wave = own / 400;
    resonance.push_back({from / own, from, from + 8, wave, wave, wave, 0.6, own, own, 5});
    waves.push_back({from / own, from, from + 8, 0.05, 0.05, 0.05, 0.6, own, own, 5});
  }
  for (const auto& stretch : joined(resonance)) EXPECT_LT(stretch.fastest, 1.16 * stretch.slowest);
  const auto found = joined(waves);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].fastest, 20);
  EXPECT_EQ(found[0].to, 480);
}

// A broad swell of roughness, 1.5 times as strong as below and five times as strong as above: half of the power lies
// within 15 % of its middle, but what is beside it is nearly as strong.
TEST(WavyStretches, BroadSwellsAreNone) {
  std::vector<double> values(static_cast<std::size_t>(10 * rate), 0.0);
  constexpr int lines = 774;
  const auto phases = normalNoise(lines, 100, 11);
  for (int line = 0; line < lines; ++line) {
    const double frequency = 248 + 0.5 * line;
    const double power = frequency < 347 ? 0.68 : frequency < 460 ? 1 : 0.2;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += 0.1 * std::sqrt(power) *
                   std::sin(2 * std::numbers::pi * frequency * static_cast<double>(i) / rate +
                            phases[static_cast<std::size_t>(line)]);
  }
  EXPECT_TRUE(stretchesOf(std::move(values)).empty());
}

// Sleepers 0.6 m apart are no corrugation.
TEST(WavyStretches, SleepersAreNone) {
  auto values = normalNoise(static_cast<std::size_t>(10 * rate), 0.5, 7);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += 4 * std::sin(2 * std::numbers::pi * speed * static_cast<double>(i) / rate / 0.6);
  EXPECT_TRUE(stretchesOf(std::move(values)).empty());
}

}  // namespace
}  // namespace squat::detection
