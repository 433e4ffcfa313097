#include "case/CaseDescription.h"
#include "commands/RunFiles.h"

#include <gmock/gmock.h>

#include <fstream>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"

namespace squat::commands {
namespace {

using ::testing::ElementsAre;
using tests::sampleResult;
using tests::TemporaryFolder;

results::RunResult unfinished() {
  auto result = sampleResult(40);
  result.complete = false;
  result.stopReason = "cancelled";
  return result;
}

TEST(RunFiles, AFinishedResultIsNotLostToAnUnfinishedOne) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  EXPECT_THAT(writeRunFiles(files, sampleResult()), ElementsAre(files.result(), files.signals()));
  EXPECT_THAT(writeRunFiles(files, unfinished()), ElementsAre(files.partialResult(), files.partialSignals()));
  EXPECT_EQ(results::readResult(files.result()).time.size(), 300U);
  EXPECT_FALSE(results::readResult(files.partialResult()).complete);
}

TEST(RunFiles, AnUnfinishedResultGivesWay) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  EXPECT_THAT(writeRunFiles(files, unfinished()), ElementsAre(files.result(), files.signals()));
  EXPECT_THAT(writeRunFiles(files, unfinished()), ElementsAre(files.result(), files.signals()));
  results::writeCheckpoint(files.checkpoint(), {});
  writeRunFiles(files, sampleResult());
  EXPECT_TRUE(results::isCompleteResult(files.result()));
  EXPECT_FALSE(std::filesystem::exists(files.checkpoint())) << "a finished run needs none";
}

TEST(RunFiles, AForeignFileUnderTheFinalNameIsLeftAlone) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  writeDurably(files.result(), "someone's notes");
  EXPECT_THAT(writeRunFiles(files, unfinished()), ElementsAre(files.partialResult(), files.partialSignals()));
  EXPECT_EQ(readWholeFile(files.result(), 100), "someone's notes");
}

TEST(RunFiles, AFolderThatCannotBeIsReportedBeforeTheRun) {
  const TemporaryFolder folder;
  writeDurably(folder / "file", "text");
  EXPECT_THROW(prepareFolder({folder / "file", "case"}), FileError);
  prepareFolder({folder / "new/deep", "case"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "new/deep"));
}

// The signals of dip.toml go to dip.csv, which is just what a measured profile beside it may be called.
TEST(RunFiles, WhatTheCaseIsReadFromIsNeverReplaced) {
  const TemporaryFolder folder;
  writeDurably(folder / "dip.toml", "[defect]\nshape = \"profile\"\nfile = \"dip.csv\"\n");
  writeDurably(folder / "dip.csv", "position [mm],height [um]\n0,0\n10,-100\n20,0\n");
  const auto description = cases::loadCase(folder / "dip.toml");
  EXPECT_THROW(keepInputsOfRun({folder.path(), "dip"}, folder / "dip.toml", description), CaseError);
  EXPECT_NO_THROW(keepInputsOfRun({folder / "out", "dip"}, folder / "dip.toml", description));
  EXPECT_NO_THROW(keepInputsOfRun({folder.path(), "other"}, folder / "dip.toml", description));
}

// Hours of another case's stopped run, against a folder name typed once more.
TEST(RunFiles, TheCheckpointOfAnotherCaseIsNotLost) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  EXPECT_THAT(keepOtherCases(files, "12345678"), ElementsAre());
  results::ArrayTree stopped;
  results::setAttribute(stopped.attributes, "case_hash", std::string("12345678"));
  results::writeCheckpoint(files.checkpoint(), stopped);
  EXPECT_THAT(keepOtherCases(files, "12345678"), ElementsAre()) << "its own run starts from the beginning";
  try {
    keepOtherCases(files, "87654321");
    FAIL() << "another case's checkpoint would be lost";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), ::testing::AllOf(::testing::HasSubstr(files.checkpoint()), ::testing::HasSubstr("-o"),
                                               ::testing::HasSubstr("--resume")));
  }
  writeDurably(files.checkpoint(), "half writ");
  EXPECT_THAT(keepOtherCases(files, "87654321"), ElementsAre()) << "no run resumes from a damaged one";
}

TEST(RunFiles, AResultOfAnotherCaseIsReplacedAndThatIsReported) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  writeRunFiles(files, sampleResult());
  const auto own = results::readResult(files.result()).caseHash;
  EXPECT_THAT(keepOtherCases(files, own), ElementsAre());
  EXPECT_THAT(keepOtherCases(files, "another"), ElementsAre(::testing::HasSubstr(files.result())));
}

TEST(RunFiles, ACheckpointOfAnotherCaseGivesWay) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path(), "case"};
  results::ArrayTree foreign;
  results::setAttribute(foreign.attributes, "case_hash", std::string("12345678"));
  results::writeCheckpoint(files.checkpoint(), foreign);
  struct Impatient : Monitor {
    std::vector<std::string> reported;
    void message(const std::string& text) override { reported.push_back(text); }
    bool cancelled() override { return true; }
  } monitor;
  const auto description = cases::loadCase("light-defect", {"tiny", {}});
  EXPECT_FALSE(runOrResume(description, {}, files, monitor).complete);
  EXPECT_THAT(monitor.reported, ::testing::Contains(::testing::HasSubstr("starts from the beginning")));
  EXPECT_FALSE(std::filesystem::exists(files.checkpoint()));
}

}  // namespace
}  // namespace squat::commands
