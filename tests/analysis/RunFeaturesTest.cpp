#include "analysis/RunFeatures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "results/RunResult.h"
#include "signals/SignalError.h"

namespace squat::analysis {
namespace {

results::RunResult result() {
  results::RunResult run;
  run.speed = 30;
  results::Channel aba{"aba_filtered", "m/s2", "", {}};
  for (int i = 0; i < 4000; ++i) {
    const double t = i / 25000.0, after = t - 0.06;
    run.time.push_back(t);
    run.position.push_back(30 * t - 1.8);
    // A larger spike at the start of the run is not the impact.
    const double start = i == 300 ? 200 : 0;
    aba.values.push_back(
        start + (after < 0 ? 0 : 80 * std::exp(-after / 0.01) * std::sin(2 * std::numbers::pi * 1000 * after)));
  }
  run.signals.push_back(aba);
  return run;
}

TEST(RunFeatures, impactIsAtTheDefect) {
  const auto features = runFeatures(result());
  EXPECT_NEAR(features.impactTime, 0.06, 1e-9);  // 1.8 m at 30 m/s
  EXPECT_EQ(features.peak, 200);
  EXPECT_NEAR(features.wavelengthByCrossings, 0.030, 0.0005);
  EXPECT_EQ(features.unit, "m/s2");
}

// Two bodies that swing together are loudest later: what stands for the impact does not move with that.
TEST(RunFeatures, aLaterSwingIsNotTheImpact) {
  auto run = result();
  run.signals[0].values[1575] = -150;  // 90 mm behind the defect
  EXPECT_NEAR(runFeatures(run).impactTime, 0.06, 1e-9);
}

TEST(RunFeatures, aRecordThatEndsBeforeTheDefectHasItsLargestValue) {
  auto run = result();
  for (double& x : run.position) x -= 10;
  EXPECT_NEAR(runFeatures(run).impactTime, 0.012, 1e-9);
}

TEST(RunFeatures, refusesWhatDoesNotFit) {
  auto run = result();
  EXPECT_THROW(runFeatures(run, {}, "no_such"), signals::SignalError);
  run.time.pop_back();
  EXPECT_THROW(runFeatures(run), signals::SignalError);
}

// 80 m/s2 of 1000 Hz after the defect and a spike of 200 at the start, which has no part in the spectrum there.
TEST(RunDigest, holdsPeakAndLines) {
  const auto digest = runDigest(result());
  EXPECT_EQ(digest.peak, 200);
  ASSERT_FALSE(digest.lines.empty());
  EXPECT_NEAR(digest.lines[0], 1000, 3);  // the step of the spectrum
}

TEST(RunDigest, ofARecordWithoutTheSignalOrTheDefectIsEmpty) {
  EXPECT_EQ(runDigest(signals::Record{}).peak, 0);
  auto early = result();
  for (double& position : early.position) position -= 100;
  EXPECT_TRUE(runDigest(early).lines.empty());
}

}  // namespace
}  // namespace squat::analysis
