#include "signals/Resample.h"

#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

// Tones up to 0.4 of the rate between the samples: the interpolator's window is 80 dB down.
TEST(Resample, interpolatesTones) {
  for (const double frequency : {10.0, 300.0, 2000.0, 4000.0}) {
    const auto series = sampled(
        400, 10000, [&](double t) { return std::sin(2 * pi * frequency * t + 0.7); }, 0.1);
    const Interpolator at(series);
    for (double t = 0.105; t < 0.135; t += 0.000137) ASSERT_NEAR(at(t), std::sin(2 * pi * frequency * t + 0.7), 2e-4);
  }
}

TEST(Resample, changesTheRateWithoutAliasing) {
  const auto series =
      sampled(5000, 50000, [](double t) { return std::sin(2 * pi * 900 * t) + std::sin(2 * pi * 9000 * t); });
  const auto slow = resample(series, 1 / 8000.0);
  EXPECT_EQ(slow.values.size(), 800u);  // 99.98 ms in steps of 125 us
  for (std::size_t i = 60; i < 740; ++i)
    ASSERT_NEAR(slow.values[i], std::sin(2 * pi * 900 * slow.timeAt(i)), 1e-3);  // 9 kHz would fold to 1 kHz
  const auto fast = resample(slow, 1 / 25000.0);
  for (std::size_t i = 300; i < 2100; ++i) ASSERT_NEAR(fast.values[i], std::sin(2 * pi * 900 * fast.timeAt(i)), 1e-3);
}

TEST(Resample, endsAndErrors) {
  const auto series = sampled(10, 10, [](double t) { return t; });
  const Interpolator at(series);
  EXPECT_DOUBLE_EQ(at(-50), 0);
  EXPECT_NEAR(at(50), 0.9, 1e-12);
  EXPECT_THROW(resample(series, 0), SignalError);
  EXPECT_THROW(resample(series, 1e-9), SignalError);  // 9e8 samples
  EXPECT_THROW(resample(series, 1e9), SignalError);   // a kernel longer than any record
  EXPECT_DOUBLE_EQ(interpolateLinear({0, 1, 3}, {5, 6, 10}, 2), 8);
  EXPECT_DOUBLE_EQ(interpolateLinear({0, 1, 3}, {5, 6, 10}, -1), 5);
  EXPECT_DOUBLE_EQ(interpolateLinear({0, 1, 3}, {5, 6, 10}, 4), 10);
}

}  // namespace
}  // namespace squat::signals
