// Studies that vary only the defect: one equilibrium and run-up for all, and the table of whole runs.
#include "case/Resolve.h"
#include "studies/SharedStart.h"

#include <gtest/gtest.h>

#include <atomic>

#include "FixtureCase.h"
#include "core/DurableFile.h"
#include "results/SampleResult.h"
#include "studies/CollectParts.h"
#include "studies/StudyTable.h"

namespace squat::studies {
namespace {

using squat::tests::TemporaryFolder;

// As coarse and short as a run may be.
cases::CaseOverrides coarse() {
  return {"tiny",
          {{"motion.run_up", "0.06"},
           {"motion.beyond", "0.07"},
           {"motion.torque", "0"},
           {"mesh.section_size", "30"},
           {"mesh.section_growth", "2"},
           {"mesh.contact_size", "8"},
           {"mesh.rolling_size", "12"},
           {"mesh.far_size", "200"},
           {"defect.shape", "cosine"},
           {"defect.length", "40"}}};
}

simulation::RunOptions bare() {
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = options.snapshots = false;
  return options;
}

StudyDefinition study(const std::vector<std::string>& variations) {
  return studyOf(tests::fixtureCase("light-defect"), coarse(), variations);
}

class CountedStart {
 public:
  explicit CountedStart(const StudyDefinition& definition) : start(definition, coarse(), bare(), 2) {}
  CaseRunner runner() {
    return [this](const cases::CaseDescription& description, const StudyPoint&, Monitor& own) {
      auto result = start.run(description, own);
      for (const auto& figure : result.performance) begun += figure.name == "seconds_equilibrium";
      return result;
    };
  }
  SharedStart start;
  std::atomic<int> begun = 0;  // equilibria within runs
};

TEST(SharedStart, TheTableIsThatOfWholeRuns) {
  const TemporaryFolder folder;
  const auto definition = study({"defect.depth=0.05,0.25", "defect.shape=cosine,cut"});
  Monitor silent;
  const auto whole = runCaseStudy(
      definition, coarse(),
      [](const cases::CaseDescription& description, const StudyPoint&, Monitor& own) {
        return simulation::runCase(description, bare(), own);
      },
      {folder / "whole", 2, false}, silent);
  for (const int jobs : {1, 2}) {
    CountedStart counted(definition);
    ASSERT_TRUE(counted.start.isShared());
    const auto table =
        runCaseStudy(definition, coarse(), counted.runner(), {folder / std::to_string(jobs), jobs, false}, silent);
    EXPECT_EQ(table.count(RowState::done), 4U);
    EXPECT_EQ(counted.begun, 0) << "every run started from the state";
    EXPECT_EQ(tableText(table), tableText(whole)) << jobs << " at once";
  }
}

// Lengths differ, so the fine zone is that of the longest in every run.
TEST(SharedStart, RunsShareTheMeshOfTheLongestDefect) {
  const auto definition = study({"defect.length=30,50"});
  CountedStart counted(definition);
  Monitor silent;
  for (const auto& point : gridOf(definition)) {
    const auto result = counted.runner()(caseAt(definition, coarse(), point), point, silent);
    ASSERT_TRUE(result.complete);
    const auto& mesh = result.resolvedCase->scenario.mesh;
    const bool isLongest = point.values.front() == "50";
    EXPECT_EQ(mesh.zoneBefore, isLongest ? 0 : 0.025) << "the longest is meshed as it would be alone";
    EXPECT_EQ(mesh.zoneBehind, isLongest ? 0 : 0.025);
  }
  EXPECT_EQ(counted.begun, 0);
}

// A part whose longest defect is short takes the zone of the whole study: collected, the bytes of one process.
TEST(SharedStart, PartsShareTheMeshOfTheWholeStudy) {
  const TemporaryFolder folder;
  const auto definition = study({"defect.length=30,50"});
  Monitor silent;
  CountedStart whole(definition);
  runCaseStudy(definition, coarse(), whole.runner(), {folder / "whole", 1, false}, silent);
  for (const auto* part : {"slice:2/2", "slice:1/2"}) {
    CountedStart counted(definition);  // a process of its own has a start of its own
    StudyOptions options{folder / "parts", 1, false};
    options.part = partitionFromText(part);
    EXPECT_EQ(runCaseStudy(definition, coarse(), counted.runner(), options, silent).count(RowState::done), 1U);
    EXPECT_EQ(counted.begun, 0);
  }
  EXPECT_EQ(tableText(writeCollected(definition, folder / "parts")),
            readWholeFile(folder / "whole/study.csv", 1000000));
}

TEST(SharedStart, OnlyWhereNothingButTheDefectVaries) {
  const auto isShared = [](const std::vector<std::string>& variations,
                           const cases::CaseOverrides& overrides = coarse()) {
    const auto definition = studyOf(tests::fixtureCase("light-defect"), overrides, variations);
    return SharedStart(definition, overrides, bare(), 1).isShared();
  };
  EXPECT_TRUE(isShared({"defect.depth=0.1,0.2", "defect.lateral=uniform,parabolic"}));
  EXPECT_TRUE(isShared({"output.filter_cutoff=1,2"}));
  EXPECT_FALSE(isShared({"defect.depth=0.1,0.2", "motion.speed=20,30"}));
  EXPECT_FALSE(isShared({"track.defect_from_sleeper=0,0.1"}));
  EXPECT_FALSE(isShared({"mesh.zone_before=0,60"}));
  EXPECT_FALSE(isShared({"defect.move_nodes=false,true"}));
}

// No room between start and defect: the runs are whole, on the mesh of the case.
TEST(SharedStart, RunsWholeWhatCannotStartThere) {
  auto overrides = coarse();
  overrides.values.emplace_back("motion.run_up", "0.031");
  const auto definition = studyOf(tests::fixtureCase("light-defect"), overrides, {"defect.depth=0.1,0.2"});
  SharedStart start(definition, overrides, bare(), 1);
  Monitor silent;
  const auto description = caseAt(definition, overrides, gridOf(definition).front());
  const auto result = start.run(description, silent);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.caseHash, cases::caseHash(description));
}

TEST(SharedStart, CancellingWhileTheStateIsMadeIsNoResult) {
  struct Cancelled : Monitor {
    bool cancelled() override { return true; }
  } cancelled;
  const auto definition = study({"defect.depth=0.1,0.2"});
  SharedStart start(definition, coarse(), bare(), 1);
  const auto description = caseAt(definition, coarse(), gridOf(definition).front());
  EXPECT_FALSE(start.run(description, cancelled).complete);
  Monitor silent;
  EXPECT_TRUE(start.run(description, silent).complete) << "and the next one makes it";
}

}  // namespace
}  // namespace squat::studies
