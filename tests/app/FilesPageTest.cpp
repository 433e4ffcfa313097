// The manual against tables of the code that no typed command writes, or writes only after minutes: heads of CSV files,
// features, exit codes.
#include "app/FilesPage.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "arch/Page.h"
#include "commands/ExitCodes.h"
#include "core/DurableFile.h"
#include "detection/DetectionFiles.h"
#include "detection/Examples.h"
#include "estimation/EstimateList.h"
#include "results/SampleResult.h"
#include "statements/Judge.h"
#include "statements/Sensitivity.h"

namespace squat {
namespace {

using ::testing::IsEmpty;

const std::string kManual = SQUAT_SOURCE_DIR "/resources/manual/";

TEST(FilesPage, HasEveryColumnOfWrittenTables) {
  FilesPage page(kManual + "files.md");
  EXPECT_THAT(page.notSaid("estimates.csv", estimation::estimatesText({})), IsEmpty());
  EXPECT_THAT(page.notSaid("squats.csv", detection::detectionCsv({})), IsEmpty());
  detection::Example passage;  // of a whole model
  passage.arrival = {{1, 0.1}};
  EXPECT_THAT(page.notSaid("examples.csv", detection::examplesText({passage})), IsEmpty());
  EXPECT_THAT(page.notSaid("validation.csv", statements::judgedCsv({})), IsEmpty());
  EXPECT_THAT(page.notSaid("validation_parameters.csv", statements::parametersCsv({})), IsEmpty());
  statements::SensitivityTable sensitivity;
  sensitivity.statements.resize(1);
  EXPECT_THAT(page.notSaid("sensitivity.csv", statements::sensitivityCsv(sensitivity)), IsEmpty());
  // STATEMENT stands for any name; all else of these tables has been seen.
  EXPECT_THAT(page.notSeen(), IsEmpty());
}

// An estimate takes minutes; its file and the lists of a detection, filled in.
TEST(FilesPage, HasEveryKeyOfWrittenJson) {
  FilesPage page(kManual + "files.md");
  estimation::Estimate estimate;
  estimate.passages.emplace_back();
  estimate.profile.emplace_back();
  const tests::TemporaryFolder folder;
  estimation::writeRow(folder.path(), estimation::rowOf("passage.csv", estimate), "key", &estimate);
  EXPECT_THAT(page.notSaidOfJson("estimate.json", readWholeFile(folder / "passage/estimate.json", 1000000)), IsEmpty());
  detection::DetectionReport report;
  detection::RecordDetection record;
  record.channels.push_back({"left", {}, {}, 2.9});
  record.faults.emplace_back();
  report.records.push_back(record);
  detection::CombinedEvent squat{{}, {0}, 0};
  squat.event.kind = detection::Kind::squat, squat.event.reason = "a reason";
  squat.event.latitude = squat.event.longitude = 1;
  squat.event.side = detection::SideJudgement{{0.9, 0.05, 0.05}};
  report.events.push_back(squat);
  EXPECT_THAT(page.notSaidOfJson("squats.json", detection::detectionJson(report)), IsEmpty());
  EXPECT_THAT(page.notSeen(), IsEmpty());
}

// A whole model's contacts: the right one has datasets of its own.
TEST(FilesPage, HasEveryDatasetOfBothContacts) {
  FilesPage page(kManual + "files.md");
  results::RunResult whole;
  whole.patches = tests::sampleResult().patches;
  whole.patches[0].right = std::make_shared<const results::PatchSnapshot>(whole.patches[0]);
  const tests::TemporaryFolder folder;
  results::writeResult(folder / "whole.h5", whole);
  EXPECT_THAT(page.notSaid(folder.path()), IsEmpty());
  for (const auto& name : page.notSeen()) EXPECT_FALSE(name.starts_with("/patch")) << name;
}

TEST(FilesPage, MissesWhatItDoesNotSay) {
  FilesPage page(kManual + "files.md");
  EXPECT_EQ(page.notSaid("estimates.csv", "passage,colour\n").size(), 1U);
  EXPECT_EQ(page.notSaid("estimates.csv", "depth [mm]\n").size(), 1U);  // another unit
  EXPECT_EQ(page.notSaid("study.csv", "motion.speed,peak [m/s2],motion.sped\n").size(), 1U);
  EXPECT_EQ(page.notSaid("no such section", "passage\n").size(), 1U);
  EXPECT_EQ(page.notSaidOfJson("squats.json", R"({"events": [{"kind": "squat", "colour": 1}]})").size(), 1U);
}

TEST(ExitCodes, StandInTheManualAndTheReadme) {
  const auto lines = arch::linesOf(kManual + "running.md");
  std::string readme;
  for (const auto& line : arch::linesOf(SQUAT_SOURCE_DIR "/README.md"))
    if (line.starts_with("Exit codes: ")) readme = line;
  for (const int code :
       {commands::kDone, commands::kCaseWrong, commands::kRunFailed, commands::kFileWrong, commands::kCancelled}) {
    const auto row = "| " + std::to_string(code) + " | ";
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return line.starts_with(row); }))
        << row;
    EXPECT_NE(readme.find(" " + std::to_string(code) + " "), std::string::npos) << code;
  }
}

}  // namespace
}  // namespace squat
