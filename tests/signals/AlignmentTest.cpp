#include "signals/Alignment.h"

#include <random>

#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;

// Answer to an impact at zero, over time [s]: two damped lines.
double answer(double t) {
  if (t < 0) return 0;
  return 60 * std::exp(-t / 0.012) * std::sin(2 * pi * 300 * t) +
         70 * std::exp(-t / 0.006) * std::sin(2 * pi * 1034 * t);
}

// A shape that belongs to the place, over position [m].
double shape(double x) {
  return x < 0 ? 0.0
               : 100 * std::exp(-x / 0.15) * std::sin(2 * pi * x / 0.029) +
                     40 * std::exp(-x / 0.3) * std::sin(2 * pi * x / 0.11);
}

std::function<double()> noise(unsigned seed) {
  auto random = std::make_shared<std::mt19937>(seed);
  return [random] { return std::normal_distribution<double>(0, 4.0)(*random); };
}

// Runs at 27 to 30 m/s, each struck at another time, with noise: aligned within one sample.
TEST(Alignment, repeatedRunsInTime) {
  const double impacts[4] = {0.0512, 0.06217, 0.04331, 0.0577777}, speeds[4] = {30, 27, 28.4, 29.1};
  std::vector<Passage> runs;
  for (unsigned r = 0; r < 4; ++r) {
    auto random = noise(r + 1);
    auto series = sampled(5000, rate, [&](double t) { return answer(t - impacts[r]) * (1 + 0.08 * r) + random(); });
    runs.push_back(passageAtSpeed(series, speeds[r]));
  }
  const auto aligned = alignInTime(runs);
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_NEAR(aligned.impact[r] - aligned.impact[0], impacts[r] - impacts[0], 1 / rate) << r;
    EXPECT_NEAR(aligned.speed[r], speeds[r], 1e-9);
    EXPECT_GT(aligned.correlation[r], 0.9);
  }
  EXPECT_NEAR(aligned.axis[1] - aligned.axis[0], 1 / rate, 1e-12);
  const auto scatter = runDispersion(aligned);
  // Peaks grow by 8 % of the first from run to run: range/mean = 0.24/1.12 = 0.214; noise moves a peak by a few m/s2.
  EXPECT_NEAR(scatter.largestPeak.range, 0.214, 0.07);
  // The lines are at the same frequencies, so the wavelength goes with the speed: mean 28.6 m/s / 1034 Hz. Noise
  // displaces the crossings where the line has decayed: 5 %.
  EXPECT_NEAR(scatter.wavelength.mean, 28.625 / 1034, 0.05 * 28.625 / 1034);
}

// The same place at 27 to 30 m/s: in position the runs coincide within one sample (1.2 mm), in time they cannot.
TEST(Alignment, repeatedRunsInPosition) {
  const double locations[4] = {1.50, 1.83, 1.221, 1.64}, speeds[4] = {30, 27, 28.4, 29.1};
  std::vector<Passage> runs;
  for (unsigned r = 0; r < 4; ++r) {
    auto random = noise(r + 11);
    auto series = sampled(5000, rate, [&](double t) { return shape(speeds[r] * t - locations[r]) + random(); });
    runs.push_back(passageAtSpeed(series, speeds[r]));
  }
  const auto aligned = alignInPosition(runs);
  EXPECT_TRUE(aligned.inPosition);
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_NEAR(aligned.impact[r] - aligned.impact[0], locations[r] - locations[0], 30 / rate) << r;
    EXPECT_NEAR(aligned.speed[r], speeds[r], 0.01);
    EXPECT_GT(aligned.correlation[r], 0.9);
  }
  const auto inTime = alignInTime(runs);
  EXPECT_LT(inTime.correlation[1], aligned.correlation[1] - 0.1);
  for (std::size_t i = 0; i < aligned.axis.size(); ++i) {
    ASSERT_LE(aligned.lowest[i], aligned.mean[i]);
    ASSERT_LE(aligned.mean[i], aligned.highest[i]);
  }
}

// A speed that changes along the run: position is its integral.
TEST(Alignment, speedAsAColumn) {
  auto series = sampled(5000, rate, [](double) { return 0.0; });
  std::vector<double> speed;
  double x = 0;
  for (std::size_t i = 0; i < 5000; ++i) {
    speed.push_back(27 + 15 * series.timeAt(i));
    if (i > 0) x += 0.5 * (speed[i] + speed[i - 1]) / rate;
    series.values[i] = shape(x - 2.0);
  }
  const auto changing = passageAtSpeed(series, speed);
  EXPECT_NEAR(changing.position.back(), 27 * 0.19996 + 7.5 * 0.19996 * 0.19996, 1e-9);
  const auto steady = passageAtSpeed(sampled(5000, rate, [](double t) { return shape(30 * t - 1.7); }), 30);
  const auto aligned = alignInPosition({steady, changing});
  EXPECT_NEAR(aligned.impact[1] - aligned.impact[0], 0.3, 30 / rate);
  EXPECT_GT(aligned.correlation[1], 0.999);
  EXPECT_NEAR(speedAt(changing, 0.1, 0.05), 28.5, 0.01);
}

TEST(Alignment, ratesMayDiffer) {
  const auto fast = passageAtSpeed(sampled(5000, rate, [](double t) { return answer(t - 0.05); }), 30);
  const auto slow = passageAtSpeed(sampled(
                                       2000, 10000, [](double t) { return answer(t - 1.07); }, 1.0),
                                   30);
  const auto aligned = alignInTime({fast, slow});
  // The slow run begins at 1 s and is struck at 1.07 s.
  EXPECT_NEAR(aligned.impact[1] - aligned.impact[0], 1.02, 1 / 10000.0);
  EXPECT_THROW(shiftBetween(fast.series, slow.series, 0), SignalError);
}

// A signal and its copy, or its double, are aligned without a rest: what differs is zero to the last digit.
TEST(Alignment, aCopyIsNotShifted) {
  const auto own = passageAtSpeed(sampled(5000, rate, [](double t) { return answer(t - 0.05); }), 30);
  auto twice = own;
  for (double& value : twice.series.values) value *= 2;
  const auto aligned = alignInTime({own, own, twice});
  EXPECT_EQ(aligned.impact[1], aligned.impact[0]);
  EXPECT_EQ(aligned.impact[2], aligned.impact[0]);
  for (std::size_t i = 0; i < aligned.axis.size(); ++i) {
    ASSERT_EQ(aligned.values[1][i], aligned.values[0][i]);
    ASSERT_EQ(aligned.values[2][i], 2 * aligned.values[0][i]);
  }
}

TEST(Alignment, dispersionIsTheSampleScatter) {
  const auto scatter = dispersionOf({90, 100, 110, 120});
  EXPECT_DOUBLE_EQ(scatter.mean, 105);
  EXPECT_NEAR(scatter.standardDeviation, std::sqrt(500.0 / 3), 1e-12);
  EXPECT_NEAR(scatter.range, 30.0 / 105, 1e-12);
}

TEST(Alignment, refusesBadInput) {
  const auto good = passageAtSpeed(sampled(5000, rate, [](double t) { return answer(t - 0.05); }), 30);
  EXPECT_THROW(alignInTime({good}), SignalError);
  EXPECT_THROW(passageAtSpeed(good.series, 0.0), SignalError);
  EXPECT_THROW(passageAtSpeed(good.series, std::vector<double>(10, 30.0)), SignalError);
  auto stopped = good;
  stopped.position[100] = stopped.position[99];
  EXPECT_THROW(alignInPosition({good, stopped}), SignalError);
  auto constant = good;
  constant.series.values.assign(5000, 1.0);
  EXPECT_THROW(alignInTime({good, constant}), SignalError);
  std::vector<double> backwards(5000, 30.0);
  backwards[7] = -1;
  try {
    passageAtSpeed(good.series, backwards);
    FAIL() << "a negative speed was accepted";
  } catch (const SignalError& error) {
    EXPECT_EQ(error.sample(), 7u);
  }
}

// A run of 25 kHz put on the coarse positions of one of 2.5 kHz: what lies above 1250 Hz is left out, not folded back
// to 500 to 1250 Hz.
TEST(Alignment, aFasterRunIsLowPassedBeforeItsPlacesAreThinnedOut) {
  const auto struck = [](double t) {
    return t < 0.05 ? 0.0 : 60 * std::exp(-(t - 0.05) / 0.02) * std::sin(2 * pi * 300 * (t - 0.05));
  };
  const auto high = [&](double t) { return struck(t) + 30 * std::sin(2 * pi * 2000 * t); };
  const auto slow = passageAtSpeed(sampled(500, 2500, struck), 30);
  const auto aligned = alignInPosition({slow, passageAtSpeed(sampled(5000, 25000, high), 30)});
  // Where nothing is struck yet: 0.3 of 30 m/s2 would be the least that folding leaves.
  double maximum = 0;
  for (std::size_t i = 0; i < aligned.axis.size(); ++i)
    if (aligned.axis[i] < -0.3 && aligned.axis[i] > -1.2) maximum = std::max(maximum, std::abs(aligned.values[1][i]));
  EXPECT_LT(maximum, 1);
}

}  // namespace
}  // namespace squat::signals
