// Which of two axle boxes moves first, by signals whose energies are known.
#include "detection/FirstArrival.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "detection/RecordMaker.h"

namespace squat::detection {
namespace {

constexpr double perSecond = 8000, pace = 30, impact = 0.2;  // [Hz], [m/s], [s]
constexpr std::size_t samples = 4000;

// 1 kHz that decays within 3 ms, from `start` on.
signals::TimeSeries ringing(double amplitude, double start) {
  signals::TimeSeries series{0, 1 / perSecond, std::vector<double>(samples, 0.0), "aba", "m/s2"};
  for (std::size_t i = 0; i < samples; ++i)
    if (const double t = static_cast<double>(i) / perSecond - start; t >= 0)
      series.values[i] = amplitude * std::exp(-t / 3e-3) * std::cos(2 * std::numbers::pi * 1000 * t);
  return series;
}

const auto anchor = static_cast<std::size_t>(std::lround(impact * perSecond));

// Nine samples from the onset on, 0.125 ms apart: the sum of their squares is written out, cos^2 of 1 kHz at 8 kHz
// being 1, 1/2, 0, 1/2 in turn. The mean over 5 ms, which is taken off, moves them by less than a hundredth: it is 40
// values long and those of a period cancel.
TEST(FirstArrival, HasTheEnergyOfTheFirstMillisecond) {
  const auto arrival = firstArrival(ringing(20, impact), ringing(10, impact), anchor, pace);
  ASSERT_TRUE(arrival);
  double expected = 0;
  for (int i = 0; i <= 8; ++i)
    expected += 400 * std::exp(-2 * i / (perSecond * 3e-3)) * (i % 4 == 0 ? 1 : i % 4 == 2 ? 0 : 0.5) / perSecond;
  EXPECT_NEAR(arrival->energy[0], expected, 0.05 * expected);
  EXPECT_NEAR(arrival->energy[1] / arrival->energy[0], 0.25, 1e-12);
  EXPECT_EQ(arrival->noise[0], 0);
}

// A wave that arrives 1.5 ms later is none of the first, however loud it is.
TEST(FirstArrival, DoesNotCountWhatArrivesLater) {
  const auto arrival = firstArrival(ringing(20, impact), ringing(40, impact + 1.5e-3), anchor, pace);
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->energy[1], 0);
  const auto exchanged = firstArrival(ringing(40, impact + 1.5e-3), ringing(20, impact), anchor, pace);
  EXPECT_EQ(exchanged->energy[0], arrival->energy[1]);
  EXPECT_EQ(exchanged->energy[1], arrival->energy[0]);
}

// White noise of 3 m/s2: 9 times the stretch; the mean over 5 ms, which is taken off, adds a fortieth. 320 samples of a
// square have a standard deviation of 8 %, 1.5 ms at 8 kHz are 13 samples. The impact is seven times as large: no value
// of the noise is taken for it (0.35 of 20 is 2.3 times, four times counts).
TEST(FirstArrival, KnowsTheNoiseAhead) {
  auto one = ringing(20, impact), other = ringing(0, impact);
  const auto a = normalNoise(samples, 3, 1), b = normalNoise(samples, 3, 2);
  for (std::size_t i = 0; i < samples; ++i) one.values[i] += a[i], other.values[i] += b[i];
  const auto arrival = firstArrival(one, other, anchor, pace);
  ASSERT_TRUE(arrival);
  for (const double noise : arrival->noise)
    EXPECT_NEAR(noise, 9 * 13 / perSecond * (1 + 1.0 / 40), 0.25 * 9 * 13 / perSecond);
  EXPECT_GT(arrival->energy[0] - arrival->noise[0], 4 * std::abs(arrival->energy[1] - arrival->noise[1]));
}

TEST(FirstArrival, IsNotKnownAtTheEndsAndInSilence) {
  const auto one = ringing(20, impact), silence = ringing(0, impact);
  EXPECT_FALSE(firstArrival(one, one, 100, pace));
  EXPECT_FALSE(firstArrival(one, one, samples - 10, pace));
  EXPECT_FALSE(firstArrival(one, silence, anchor, pace));
  EXPECT_FALSE(firstArrival(silence, silence, anchor, pace));
}

}  // namespace
}  // namespace squat::detection
