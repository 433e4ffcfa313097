// One run beside the paper, and what every run must show.
#include "case/CaseDescription.h"
#include "statements/JudgeRun.h"

#include <gmock/gmock.h>

#include "case/CaseFile.h"
#include "statements/RunChecks.h"

namespace squat::statements {
namespace {

// A ramp of 1 m/s2 a metre, which has its mean in the middle of any stretch; sampled every millimetre.
results::RunResult ramp(const std::string& name = "light-defect",
                        const std::vector<std::pair<std::string, std::string>>& sets = {}) {
  results::RunResult result;
  results::setCase(result, cases::loadCase(name, {"tiny", sets}));
  result.complete = true;
  result.speed = 30;
  results::Channel aba{"aba_filtered", "m/s2", "", {}};
  for (int i = -400; i <= 400; ++i) {
    result.position.push_back(1e-3 * i);
    result.time.push_back(result.position.back() / 30);
    aba.values.push_back(result.position.back());
  }
  result.signals.push_back(aba);
  return result;
}

const Reference& paper() {
  static const auto reference = installedReference();
  return reference;
}

TEST(JudgeRun, JudgesTheStatementsAboutThatRunAlone) {
  const auto run = judgeRun(paper(), ramp());
  ASSERT_FALSE(run.judged.empty());
  for (const auto& one : run.judged) {
    EXPECT_EQ(one.statement.run, "light-defect");
    EXPECT_EQ(one.statement.against, "");
  }
  const auto all = judge(paper(), {{"light-defect", ramp()}}, "tiny");
  std::size_t own = 0;
  for (const auto& one : all) {
    if (one.statement.run != "light-defect" || !one.statement.against.empty()) continue;
    EXPECT_EQ(run.judged.at(own).value, one.value) << one.statement.name;
    EXPECT_EQ(run.judged.at(own).verdict, one.verdict) << one.statement.name;
    EXPECT_EQ(run.judged.at(own).elsewhere, one.elsewhere) << one.statement.name;
    ++own;
  }
  EXPECT_EQ(run.judged.size(), own);
}

TEST(JudgeRun, JudgesNothingElse) {
  EXPECT_TRUE(judgeRun(paper(), ramp("light-defect", {{"motion.speed", "25"}})).judged.empty()) << "a changed key";
  auto stopped = ramp();
  stopped.complete = false;
  EXPECT_TRUE(judgeRun(paper(), stopped).judged.empty());
  EXPECT_TRUE(judgeRun(paper(), results::RunResult{}).judged.empty());
}

// 0.2 m of the ramp deviate 0.1 m/s2 from their mean, wherever they lie.
TEST(RunChecks, ResidualVibrationIsTakenWhereTheRailIsSmooth) {
  auto result = ramp();
  EXPECT_NEAR(residualVibration(result)->largest, 0.1, 1e-3);  // the sampling step
  EXPECT_NEAR(residualVibration(result)->length, 0.2, 1e-3);
  result.signals[0].values[320] = 9;  // at -80 mm: before a short defect, within a long one
  EXPECT_GT(residualVibration(result)->largest, 8);
  result.profilePosition = {-0.4, -0.15, 0.4}, result.profileHeight = {0, -1e-4, 0};
  EXPECT_NEAR(residualVibration(result)->largest, 0.1, 1e-3);
  result.profilePosition = {-0.4, -0.39, 0.4};  // eleven samples
  EXPECT_NEAR(residualVibration(result)->length, 0.01, 1e-9);
  result.profilePosition = {-0.5, -0.45, 0.4};
  EXPECT_FALSE(residualVibration(result));
  EXPECT_FALSE(residualVibration(results::RunResult{}));
}

TEST(RunChecks, LimitsStandInOnePlace) {
  const auto limit = residualVibrationLimit(paper());
  ASSERT_TRUE(limit);
  EXPECT_EQ(*limit, 5);  // [m/s2] 5 % of the peak at the light defect, as the statement says
  EXPECT_FALSE(residualVibrationLimit(Reference{}));
  auto result = ramp();
  EXPECT_FALSE(energyError(result));
  result.performance = {{"energy_residual", "1", "", -0.002}};
  EXPECT_DOUBLE_EQ(energyError(result).value(), 0.002);
}

}  // namespace
}  // namespace squat::statements
