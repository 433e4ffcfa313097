#include "case/CaseDescription.h"
#include "studies/CaseStudy.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "FixtureCase.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::studies {
namespace {

using ::testing::HasSubstr;

const std::string lightDefect = std::string(SQUAT_SOURCE_DIR) + "/resources/cases/light-defect.toml";

// What a run might give: ABA and contact force with the numbers of the case in them.
results::RunResult pretend(const cases::CaseDescription& description) {
  results::RunResult run;
  run.complete = true;
  run.speed = description.motion.speed;
  results::Channel aba{"aba_filtered", "m/s2", "", {}}, force{"contact_force", "N", "", {}};
  for (int i = 0; i < 3000; ++i) {
    const double t = i / 25000.0, after = t - 0.04;
    run.time.push_back(t);
    run.position.push_back(run.speed * after);
    aba.values.push_back(after < 0 ? 0
                                   : 1e6 * description.defect.depth * std::exp(-after / 0.01) *
                                         std::sin(2 * std::numbers::pi * 1000 * after));
    force.values.push_back(80000 + aba.values.back());
  }
  run.signals = {aba, force};
  return run;
}

TEST(CaseStudy, keysAreThoseOfTheTable) {
  const auto definition = studyOf(lightDefect, {}, {"defect.depth=0.1:0.3:3", "motion.speed=27,30"});
  EXPECT_EQ(gridOf(definition).size(), 6u);
  EXPECT_EQ(definition.caseHash.size(), 8u);
  const auto description = caseAt(definition, {}, gridOf(definition)[1]);
  EXPECT_DOUBLE_EQ(description.defect.depth, 1e-4);
  try {
    studyOf(lightDefect, {}, {"defect.deepth=0.1:0.3:3", "defect.depth=0.1:1e9:2", "motion.speed"});
    FAIL() << "wrong keys were accepted";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.problems().size(), 3u);
    EXPECT_THAT(error.what(), HasSubstr("defect.depth"));
  }
}

// The rows would all be equal: an analytic depth of a sampled profile, a torque beside a traction coefficient. A key
// that has an effect at some of the points may be varied.
TEST(CaseStudy, refusesAKeyThatHasNoEffectAtAnyPoint) {
  const auto sampled = tests::fixtureCase("light-defect");
  const auto refusal = [&](const cases::CaseOverrides& overrides, const std::string& variation) -> std::string {
    try {
      studyOf(sampled, overrides, {variation});
    } catch (const CaseError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal({}, "defect.depth=0.1,0.3"),
              HasSubstr("defect.depth: no effect because defect.shape is profile"));
  EXPECT_THAT(refusal({"", {{"motion.traction_coefficient", "0.1"}}}, "motion.torque=1000:3000:3"),
              HasSubstr("motion.traction_coefficient is 0.1"));
  EXPECT_EQ(refusal({}, "defect.height_scale=0.5,1"), "accepted");
  EXPECT_EQ(refusal({"", {{"defect.shape", "cosine"}}}, "defect.depth=0.1,0.3"), "accepted");
  EXPECT_NO_THROW(studyOf(sampled, {}, {"defect.shape=profile,cosine", "defect.depth=0.1,0.3"}));
}

// A measured profile may be called study.csv; and a study.csv without its study.json may be anybody's.
TEST(CaseStudy, neverReplacesWhatIsNotItsOwn) {
  const auto folder =
      (std::filesystem::temp_directory_path() / ("squat-study-inputs-" + std::to_string(::getpid()))).string();
  makeFolder(folder);
  const std::string profile = "position [mm],height [um]\n0,0\n10,-100\n20,0\n";
  writeDurably(folder + "/dip.toml", "[defect]\nshape = \"profile\"\nfile = \"study.csv\"\n");
  writeDurably(folder + "/study.csv", profile);
  Monitor monitor;
  const CaseRunner runner = [](const auto& description, const auto&, Monitor&) { return pretend(description); };
  const auto own = studyOf(folder + "/dip.toml", {}, {"motion.speed=27,30"});
  EXPECT_THROW(runCaseStudy(own, {}, runner, {folder, 1, false}, monitor), CaseError);
  const auto other = studyOf(lightDefect, {}, {"motion.speed=27,30"});
  EXPECT_THROW(runCaseStudy(other, {}, runner, {folder, 1, false}, monitor), CaseError);
  EXPECT_EQ(readWholeFile(folder + "/study.csv", 1000), profile);
  EXPECT_FALSE(std::filesystem::exists(folder + "/study.json"));
  EXPECT_EQ(runCaseStudy(own, {}, runner, {folder + "/out", 1, false}, monitor).count(RowState::done), 2u);
  std::filesystem::remove_all(folder);
}

TEST(CaseStudy, runsEveryPoint) {
  const auto folder =
      (std::filesystem::temp_directory_path() / ("squat-case-study-" + std::to_string(::getpid()))).string();
  const auto definition = studyOf(lightDefect, {}, {"defect.depth=0.1:0.3:3"});
  Monitor monitor;
  const auto table = runCaseStudy(
      definition, {},
      [](const cases::CaseDescription& description, const StudyPoint&, Monitor&) { return pretend(description); },
      {folder, 2, false}, monitor);
  std::filesystem::remove_all(folder);
  ASSERT_EQ(table.count(RowState::done), 3u);
  const auto value = [&](std::size_t row, const std::string& name) {
    for (const auto& [key, number] : table.rows[row].features)
      if (key == name) return number;
    return std::nan("");
  };
  EXPECT_NEAR(value(2, "peak [m/s2]") / value(0, "peak [m/s2]"), 3, 1e-9);
  EXPECT_NEAR(value(0, "largest contact force [N]"), 80000 + value(0, "maximum [m/s2]"), 1e-9);
}

// An edit while the study runs would put rows of two cases into one table.
TEST(CaseStudy, aCaseThatChangesMeanwhileFailsItsRows) {
  const auto folder =
      (std::filesystem::temp_directory_path() / ("squat-edited-study-" + std::to_string(::getpid()))).string();
  std::filesystem::create_directories(folder);
  const auto path = folder + "/case.toml";
  writeDurably(path, "[motion]\nspeed = 30\n");
  const auto definition = studyOf(path, {}, {"defect.depth=0.1:0.3:3"});
  Monitor monitor;
  const auto table = runCaseStudy(
      definition, {},
      [&](const cases::CaseDescription& description, const StudyPoint&, Monitor&) {
        writeDurably(path, "[motion]\nspeed = 31\n");
        return pretend(description);
      },
      {folder, 1, false}, monitor);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(table.count(RowState::done), 1u);
  EXPECT_EQ(table.count(RowState::failed), 2u);
}

}  // namespace
}  // namespace squat::studies
