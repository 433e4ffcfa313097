#include "signals/Anchor.h"

#include "signals/Alignment.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::sampled;

// Strikes at 0.02 s and, twice as strongly, at 0.05 s.
TimeSeries twoStrikes() {
  return sampled(100, 1000, [](double t) {
    return std::abs(t - 0.02) < 1e-9 ? 1.0 : std::abs(t - 0.05) < 1e-9 ? -2.0 : 0.0;
  });
}

TEST(Anchor, isTheDefectWherePositionZeroIsPassed) {
  Passage passage{twoStrikes(), {}};
  for (int i = 0; i < 100; ++i) passage.position.push_back(0.03 * i - 0.615);
  const auto anchor = anchorOf(passage);
  EXPECT_EQ(anchor.rule, AnchorRule::defect);
  EXPECT_NEAR(anchor.time, 0.0205, 1e-12);  // 0.615 m at 30 m/s, between two samples
}

// Positions made from speed and time begin at zero: that is no defect. Chainage of a line does not pass it at all.
TEST(Anchor, isTheLargestValueWithoutADefectAtZero) {
  EXPECT_NEAR(anchorOf(passageAtSpeed(twoStrikes(), 30.0)).time, 0.05, 1e-12);
  EXPECT_EQ(anchorOf(passageAtSpeed(twoStrikes(), 30.0)).rule, AnchorRule::largestValue);
  Passage chainage = passageAtSpeed(twoStrikes(), 30.0);
  for (double& x : chainage.position) x += 12345.6;
  EXPECT_NEAR(anchorOf(chainage).time, 0.05, 1e-12);
  EXPECT_NEAR(anchorOf({twoStrikes(), {}}).time, 0.05, 1e-12);  // no positions
}

TEST(Anchor, alignmentAndComparisonKeepToIt) {
  const auto first = [](double t) {
    return t < 0.06 ? 0.0 : 50 * std::exp(-(t - 0.06) / 0.01) * std::sin(6000 * (t - 0.06));
  };
  auto series = sampled(4000, 25000, first);
  series.values[1575] = -150;  // 90 mm behind the defect
  Passage run{series, {}};
  for (int i = 0; i < 4000; ++i) run.position.push_back(30 * (i / 25000.0) - 1.8);
  EXPECT_NEAR(alignInTime({run, run}).impact[1], 0.06, 0.5 / 25000);  // to half a sample
  EXPECT_NEAR(alignInPosition({run, run}).impact[0], 0, 0.5 * 30 / 25000);
}

}  // namespace
}  // namespace squat::signals
