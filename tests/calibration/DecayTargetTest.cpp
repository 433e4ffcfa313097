// Decay rates as targets: residuals by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "TemporaryFolder.h"
#include "calibration/DecayResiduals.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::calibration {
namespace {

class DecayTargets : public testing::Test {
 protected:
  // 100 Hz: 4 dB/m twice; 200 Hz: 1 and 100 dB/m, mean 50.5, half of their range of 20 dB; sideways nothing.
  void SetUp() override {
    writeDurably(folder_ / "rates.csv", std::string_view("direction,100 Hz [dB/m],200 Hz [dB/m]\nv,4,1\nv,4,100\n"));
    writeDurably(folder_ / "targets.json", std::string_view(R"({"schema": "squat-targets", "schema_version": 1,
                   "decay": [{"file": "rates.csv", "weight": 2, "tolerance": 2}]})"));
  }
  tests::TemporaryFolder folder_;
};

TEST_F(DecayTargets, AreReadFromATargetFile) {
  const auto targets = readTargets({folder_ / "targets.json"}, "light-defect");
  ASSERT_EQ(targets.decays.size(), 1u);
  EXPECT_EQ(targets.count(), 1u);
  EXPECT_EQ(targets.weights(), std::vector<double>{2});
  EXPECT_EQ(targets.names(), std::vector<std::string>{"rates"});
}

TEST_F(DecayTargets, ResidualsAreDecibelsOverToleranceOrHalfTheRange) {
  const auto targets = readTargets({folder_ / "targets.json"}, "light-defect");
  receptance::DecayRates computed;
  computed.band = {100, 200}, computed.vertical = {8, 5.05}, computed.lateral = {1, 1};
  const auto value = decayValue(readMeasuredDecays(targets.decays[0]), computed);
  ASSERT_EQ(value.residuals.size(), 2u);
  EXPECT_NEAR(value.residuals[0], 10 * std::log10(2.0) / 2, 1e-12);
  EXPECT_NEAR(value.residuals[1], -10.0 / 10, 1e-12);
  EXPECT_NEAR(*value.value, std::sqrt((2.2655 + 1) / 2), 1e-3);
  EXPECT_TRUE(value.isMet);
}

TEST_F(DecayTargets, WithoutAThirdOctaveWithinTheLimitsIsAnError) {
  auto targets = readTargets({folder_ / "targets.json"}, "light-defect");
  targets.decays[0].lowest = 1000;
  EXPECT_THROW(readMeasuredDecays(targets.decays[0]), FileError);
}

}  // namespace
}  // namespace squat::calibration
