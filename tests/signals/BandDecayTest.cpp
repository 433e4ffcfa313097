#include "signals/BandDecay.h"

#include <gtest/gtest.h>

#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;
const Band band{"", 850, 1150};

TimeSeries tone(double decay) {
  return sampled(5000, rate, [&](double t) {
    return t < 0.05 ? 0.0 : std::exp(-(t - 0.05) / decay) * std::cos(2 * pi * 1000 * (t - 0.05));
  });
}

// |a exp(i w t)| = a: away from the ends, where the zeros behind the record ring, by a thousandth.
TEST(BandDecay, envelopeOfAToneIsItsAmplitude) {
  const auto values = envelope(sampled(4000, rate, [](double t) { return 3 * std::sin(2 * pi * 1000 * t + 0.3); }));
  for (std::size_t i = 500; i < 3500; ++i) ASSERT_NEAR(values[i], 3, 0.01) << i;
}

TEST(BandDecay, aKickRingsAsLongAsTheFilter) {
  auto kick = sampled(5000, rate, [](double) { return 0.0; });
  kick.values[1250] = 5;
  const auto decay = bandDecay(kick, 0.045, 0.19, band);
  EXPECT_NEAR(decay.ratio(), 1, 0.02);  // a sample of about a hundred
  EXPECT_TRUE(decay.ended);
  // A band of width B rings for about 1/B to 2/B: the envelope of an ideal one falls to a tenth for good at about
  // 3/(pi B) to 10/(pi B).
  EXPECT_GT(decay.own, 0.9 / 300);
  EXPECT_LT(decay.own, 3.2 / 300);
}

// Long after the start, the filter passes exp(-t/T) at its centre as it is: a tenth after T ln 10. The beginning is
// rounded off by the filter, whose largest value comes about half its own ringing later and lower.
TEST(BandDecay, aVibrationRingsLonger) {
  for (const double decay : {0.01, 0.02}) {
    const auto result = bandDecay(tone(decay), 0.045, 0.19, band);
    EXPECT_NEAR(result.duration, decay * std::log(10), 0.4 * result.own) << decay;
    EXPECT_GT(result.ratio(), 2) << decay;
  }
}

// A strong line beside the band passes its flanks and rings on when the band itself is quiet: its frequency tells. 784
// Hz pass this filter with 3 % of their amplitude (order 4 forward and back: 1 / (1 + 1.54^8)).
TEST(BandDecay, whatRingsHasAFrequency) {
  EXPECT_NEAR(bandDecay(tone(0.02), 0.045, 0.19, band).frequency, 1000, 1);
  const auto beside = sampled(5000, rate, [&](double t) {
    const double after = std::max(0.0, t - 0.05);  // swings in over 5 ms
    return (1 - std::exp(-after / 0.005)) * std::exp(-after / 0.1) * std::sin(2 * pi * 784 * after);
  });
  const auto result = bandDecay(beside, 0.045, 0.19, band);
  EXPECT_GT(result.ratio(), 2);
  EXPECT_NEAR(result.frequency, 784, 8);  // the filter's slope lifts the near side of the line
}

// The end of a record: the filter's own half there is not looked at.
TEST(BandDecay, aRecordThatEndsTooSoonSaysSo) {
  const auto result = bandDecay(tone(1.0), 0.045, 0.2, band);
  EXPECT_FALSE(result.ended);
  EXPECT_NEAR(result.duration, 0.15 - result.own / 2, 0.01);
}

TEST(BandDecay, refusesBadInput) {
  EXPECT_THROW(bandDecay(tone(0.01), 0.045, 0.19, {"", 850, 13000}), SignalError);
  EXPECT_THROW(bandDecay(tone(0.01), 0.045, 0.19, band, 0), SignalError);
  EXPECT_THROW(bandDecay(tone(0.01), 0.045, 0.19, band, 1), SignalError);
  EXPECT_THROW(bandDecay(tone(0.01), 3, 4, band), SignalError);
}

}  // namespace
}  // namespace squat::signals
