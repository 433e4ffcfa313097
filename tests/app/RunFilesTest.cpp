#include "commands/RunFiles.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"

namespace squat::commands {
namespace {

using ::testing::ElementsAre;
using testing::sampleResult;
using testing::TemporaryFolder;

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

TEST(RunFiles, AFolderThatCannotBeIsToldBeforeTheRun) {
  const TemporaryFolder folder;
  writeDurably(folder / "file", "text");
  EXPECT_THROW(prepareFolder({folder / "file", "case"}), FileError);
  prepareFolder({folder / "new/deep", "case"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "new/deep"));
}

}  // namespace
}  // namespace squat::commands
