// One input at a time, on a run that is made up: the table, which row is the base, and that a stopped call is resumed.
#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "statements/Sensitivity.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "results/SampleResult.h"

namespace squat::statements {
namespace {

using ::testing::HasSubstr;
using tests::TemporaryFolder;

// A decaying wave whose height is 100 times the case's height scale and 1e-4 of its distance from the sleeper.
results::RunResult madeUp(const cases::CaseDescription& description) {
  results::RunResult result;
  result.complete = true;
  result.speed = 30;
  results::Channel aba{"aba_filtered", "m/s2", "", {}};
  const double height = 100 * description.defect.heightScale - 10 * description.track.defectFromSleeper;
  for (int i = 0; i < 1000; ++i) {
    const double time = i / 25000.0, after = time - 0.02;
    result.time.push_back(time);
    result.position.push_back(30 * after);
    aba.values.push_back(
        after < -1e-9 ? 0.0 : height * std::exp(-after / 0.004) * std::cos(2 * std::numbers::pi * 1000 * after));
  }
  result.signals.push_back(aba);
  return result;
}

Reference reference() {
  Reference reference;
  reference.runs = {{"light", tests::fixtureCase("light-defect"), {{"motion.beyond", "0.6"}}}};
  Statement peak;
  peak.name = "peak";
  peak.run = "light";
  peak.measure = "maximum";
  peak.low = 80;
  peak.high = 120;
  peak.unit = "m/s2";
  Statement other = peak;
  other.against = "light";  // about two runs: not shown
  reference.statements = {peak, other};
  reference.sensitivityRun = "light";
  reference.sensitivity = {{"defect.height_scale", "depth", {"0.7", "1", "1.3"}},
                           {"track.defect_from_sleeper", "L", {"0.3"}}};
  return reference;
}

TEST(Sensitivity, OneInputAtATime) {
  const TemporaryFolder folder;
  Monitor monitor;
  int runs = 0;
  const studies::CaseRunner run = [&](const cases::CaseDescription& description, const studies::StudyPoint&, Monitor&) {
    EXPECT_NEAR(description.motion.beyond, 0.6, 1e-12);
    ++runs;
    return madeUp(description);
  };
  const auto table = sensitivity(reference(), {}, run, {folder.path(), 1, false}, monitor);
  ASSERT_EQ(table.statements.size(), 1u);
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(runs, 4);
  const double expected[4] = {70, 100, 130, 97};
  const bool met[4] = {false, true, false, true};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(table.rows[i].numbers[0].value(), expected[i], 1e-9) << i;
    EXPECT_EQ(table.rows[i].met[0], met[i]) << i;
    EXPECT_EQ(table.rows[i].base, i == 1) << i;
  }
  EXPECT_THAT(sensitivityCsv(table), HasSubstr("key,value,unit,base,peak [m/s2],met,message\n"));
  EXPECT_THAT(sensitivityCsv(table), HasSubstr("track.defect_from_sleeper,0.3,m,no,97,yes,\n"));
  // Once more: what stands in the folder is not run again.
  sensitivity(reference(), {}, run, {folder.path(), 1, false}, monitor);
  EXPECT_EQ(runs, 4);
}

// A value that no case can have fails its own row, not the table: solids and box weigh more than 500 kg.
TEST(Sensitivity, AValueThatCannotBeIsARowOfItsOwn) {
  const TemporaryFolder folder;
  Monitor monitor;
  const studies::CaseRunner run = [&](const cases::CaseDescription& description, const studies::StudyPoint&, Monitor&) {
    return madeUp(description);
  };
  auto with = reference();
  with.sensitivity = {{"wheelset.total_mass", "mass", {"500", "950"}}};
  const auto table = sensitivity(with, {}, run, {folder.path(), 1, false}, monitor);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(table.rows[0].message, HasSubstr("wheelset.total_mass"));
  EXPECT_FALSE(table.rows[0].base);
  EXPECT_TRUE(table.rows[1].numbers[0]);
}

}  // namespace
}  // namespace squat::statements
