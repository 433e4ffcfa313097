// Power in bands against what noise and tones of known power have in them.
#include "detection/BandPower.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "detection/LocalLevel.h"

namespace squat::detection {
namespace {

using ::testing::Each;

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

signals::TimeSeries noise(std::size_t count, double rate, double sigma) {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal(0, sigma);
  signals::TimeSeries series{0, 1 / rate, std::vector<double>(count), "aba", "m/s2"};
  for (auto& value : series.values) value = normal(engine);
  return series;
}

// White noise of variance s^2 at the rate f has the density 2 s^2 / f. 60 s give each band at least 2 * 90 Hz * 60 s =
// 10,800 independent values, a scatter of 1.4 %; the voices' overlap beyond the band's edges is worth another 1 %.
TEST(BandPower, OfWhiteNoiseIsDensityTimesWidth) {
  const double rate = 5000, sigma = 3;
  const auto power = bandPower(noise(300'000, rate, sigma));
  for (std::size_t b = 0; b < detectionBands().size(); ++b) {
    const auto& band = detectionBands()[b];
    const double expected = 2 * sigma * sigma / rate * (band.high - band.low);
    EXPECT_NEAR(meanOf(power.power[b]) / expected, 1, 0.04) << band.name;
  }
}

// A tone inside a band has half the square of its amplitude there; six voices an octave ripple by some per cent.
TEST(BandPower, OfAToneIsHalfTheSquareOfItsAmplitude) {
  const double rate = 5000, frequency = 1060, amplitude = 2;
  signals::TimeSeries series{0, 1 / rate, std::vector<double>(20'000), "aba", "m/s2"};
  for (std::size_t i = 0; i < series.values.size(); ++i)
    series.values[i] = amplitude * std::sin(2 * std::numbers::pi * frequency * series.timeAt(i));
  const auto power = bandPower(series);
  double sum = 0;
  for (const auto& row : power.power) sum += row[row.size() / 2];
  EXPECT_NEAR(sum, 0.5 * amplitude * amplitude, 0.05 * 0.5 * amplitude * amplitude);
  EXPECT_GT(power.power[4][power.cells() / 2], 0.8 * sum) << "900-1250 Hz";
  EXPECT_LT(power.power[1][power.cells() / 2], 1e-6 * sum) << "130-320 Hz";
}

TEST(BandPower, ASlowRecordHasNoHighBands) {
  EXPECT_TRUE(shows(5000, detectionBands().back()));
  EXPECT_FALSE(shows(4000, detectionBands().back())) << "2000 Hz is half of the rate";
  const auto power = bandPower(noise(20'000, 2000, 1));
  EXPECT_THAT(power.power[5], Each(0.0));
  EXPECT_GT(meanOf(power.power[1]), 0);
}

// Means of k squares of normal numbers: the level is the mean, 1, although an event that is a hundred times as loud
// fills a third of the window. 2000 values scatter by sqrt(2 / k / 2000) and the correction is good to a per cent.
TEST(LocalLevel, IsTheMeanOfTheNoiseAndDoesNotSeeEvents) {
  const int k = 8;
  std::mt19937 engine(9);
  std::normal_distribution<double> normal(0, 1);
  std::vector<double> values(2000);
  for (auto& value : values) {
    value = 0;
    for (int i = 0; i < k; ++i) {
      const double x = normal(engine);
      value += x * x / k;
    }
  }
  EXPECT_NEAR(localLevel(values, 1000, k)[1000], 1, 0.05);
  auto events = values;
  for (std::size_t i = 900; i < 1100; ++i) events[i] *= 100;
  EXPECT_NEAR(localLevel(events, 500, k)[1000] / localLevel(values, 500, k)[1000], 1.15, 0.1)
      << "a fifth of the window is louder: the median moves from 50 to 62 % of what is left";
}

TEST(LocalLevel, SmoothingKeepsTheMeanAndIsCentred) {
  std::vector<double> values(101, 0.0);
  values[50] = 5;
  const auto wide = smoothed(values, 5);
  EXPECT_DOUBLE_EQ(wide[48], 1);
  EXPECT_DOUBLE_EQ(wide[52], 1);
  EXPECT_DOUBLE_EQ(wide[47], 0);
  EXPECT_DOUBLE_EQ(wide[53], 0);
}

}  // namespace
}  // namespace squat::detection
