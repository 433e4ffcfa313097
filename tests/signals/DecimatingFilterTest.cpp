#include "signals/DecimatingFilter.h"

#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;

constexpr std::size_t factor = 128;
constexpr double step = 1 / (25000.0 * factor);  // 3.2 MHz

// Both channels of a record of n input samples.
std::vector<TimeSeries> pass(std::size_t n, const std::function<double(double)>& one,
                             const std::function<double(double)>& other) {
  DecimatingFilter filter(step, factor, 2);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) * step;
    const double sample[2] = {one(t), other(t)};
    filter.push(sample);
  }
  return filter.finish();
}

double largest(const std::vector<double>& values, std::size_t from, std::size_t to) {
  double result = 0;
  for (std::size_t i = from; i < to; ++i) result = std::max(result, std::abs(values[i]));
  return result;
}

// Anything above 12.5 kHz would fold into the output: 23 kHz to 2 kHz, 13 kHz to 12 kHz, 50 kHz to zero.
TEST(DecimatingFilter, leavesNoAlias) {
  const std::size_t n = 400 * factor;
  for (const double frequency : {12500.0, 13000.0, 23000.0, 23076.9, 27000.0, 50000.0, 411000.0}) {
    const auto out = pass(
        n, [&](double t) { return std::sin(2 * pi * frequency * t); },
        [&](double t) { return std::cos(2 * pi * frequency * t); });
    // Away from the ends: there the repeated sample makes a step, which is not a tone.
    EXPECT_LT(largest(out[0].values, 30, 370), 1e-4) << frequency;
    EXPECT_LT(largest(out[1].values, 30, 370), 1e-4) << frequency;
  }
}

TEST(DecimatingFilter, passBandIsFlatAndWithoutDelay) {
  const std::size_t n = 200 * factor;
  for (const double frequency : {50.0, 1000.0, 2000.0, 4000.0, 6000.0}) {
    const auto out = pass(
        n, [&](double t) { return std::sin(2 * pi * frequency * t); }, [](double t) { return t; });
    for (std::size_t k = 30; k < 170; ++k) {
      const double t = out[0].timeAt(k);
      ASSERT_NEAR(out[0].values[k], std::sin(2 * pi * frequency * t), 1.15e-3) << frequency;  // 0.01 dB
      ASSERT_NEAR(out[1].values[k], t, 1e-12);  // a symmetrical filter of gain one leaves a straight line as it is
    }
  }
  const DecimatingFilter filter(step, factor, 1);
  for (double f = 0; f <= 6000; f += 100) ASSERT_NEAR(20 * std::log10(filter.gainAt(f)), 0, 0.01) << f;
  for (double f = 12500; f <= 200000; f += 250) ASSERT_LT(20 * std::log10(filter.gainAt(f)), -80) << f;
}

TEST(DecimatingFilter, endsRepeatTheOuterSamples) {
  const auto out = pass(
      50 * factor + 17, [](double) { return 4.0; }, [](double t) { return 1 - 1000 * t; });
  ASSERT_EQ(out[0].values.size(), 51u);
  for (const double value : out[0].values) ASSERT_NEAR(value, 4.0, 1e-12);
  // The kink of the ramp at the repeated samples is smoothed over about one period of the cut-off, 0.1 ms: 0.1.
  EXPECT_NEAR(out[1].values.front(), 1.0, 0.03);
  EXPECT_NEAR(out[1].values[20], 1 - 1000 * out[1].timeAt(20), 1e-9);
  EXPECT_NEAR(out[1].values.back(), 1 - 1000 * out[1].timeAt(50), 0.03);
}

// Fewer samples than the filter is long, and even a single one.
TEST(DecimatingFilter, shortRecordsWork) {
  for (const std::size_t n : {1u, 2u, 128u, 129u, 700u}) {
    const auto out = pass(
        n, [](double) { return -2.0; }, [](double) { return 5.0; });
    ASSERT_EQ(out[0].values.size(), (n - 1) / factor + 1);
    for (const double value : out[0].values) ASSERT_NEAR(value, -2.0, 1e-12) << n;
    for (const double value : out[1].values) ASSERT_NEAR(value, 5.0, 1e-12) << n;
  }
  EXPECT_TRUE(DecimatingFilter(step, factor, 1).finish()[0].values.empty());
}

TEST(DecimatingFilter, goesOnFromAStoredState) {
  const auto value = [](std::size_t i) { return std::sin(0.001 * static_cast<double>(i * i % 7919)); };
  DecimatingFilter whole(step, factor, 1), first(step, factor, 1), second(step, factor, 1);
  const std::size_t n = 60 * factor, stop = 23 * factor + 11;
  for (std::size_t i = 0; i < n; ++i) {
    const double sample = value(i);
    whole.push(&sample);
    if (i < stop) first.push(&sample);
  }
  second.restore(first.state());
  for (std::size_t i = stop; i < n; ++i) {
    const double sample = value(i);
    second.push(&sample);
  }
  EXPECT_EQ(whole.finish()[0].values, second.finish()[0].values);  // the same bits
  EXPECT_EQ(whole.latest(0), second.latest(0));
  EXPECT_THROW(DecimatingFilter(step, factor, 2).restore(first.state()), SignalError);
}

TEST(DecimatingFilter, finishDoesNotDisturb) {
  DecimatingFilter one(step, factor, 1), other(step, factor, 1);
  for (std::size_t i = 0; i < 40 * factor; ++i) {
    const double sample = static_cast<double>(i % 1000);
    one.push(&sample);
    other.push(&sample);
    if (i % 777 == 0) one.finish();
  }
  EXPECT_EQ(one.finish(0.5)[0].values, other.finish()[0].values);
  EXPECT_EQ(one.finish(0.5)[0].start, 0.5);
}

TEST(DecimatingFilter, refusesRatesThatDoNotFit) {
  EXPECT_THROW(DecimatingFilter(0, factor, 1), SignalError);
  EXPECT_THROW(DecimatingFilter(step, 1, 1), SignalError);
  EXPECT_THROW(DecimatingFilter(step, factor, 0), SignalError);
  EXPECT_THROW(DecimatingFilter(step, 4 * factor, 1), SignalError);  // output at 6.25 kHz
}

}  // namespace
}  // namespace squat::signals
