// The folder of a command's files: made with its parents, and not left behind empty.
#include "commands/OutputFolder.h"

#include <gtest/gtest.h>

#include "core/DurableFile.h"
#include "results/SampleResult.h"

namespace squat::commands {
namespace {

using tests::TemporaryFolder;

TEST(OutputFolder, GoesAgainWithTheParentsThatItMadeWhereNothingWasWritten) {
  const TemporaryFolder folder;
  {
    const OutputFolder output(folder / "new/deep/");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "new/deep"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(OutputFolder, StaysWithAFileInItAndWhereItStoodBefore) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "old");
  {
    const OutputFolder output(folder / "new");
    const OutputFolder old(folder / "old");
    writeDurably(folder / "new/file", std::string_view("text"));
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "new/file"));
  EXPECT_TRUE(std::filesystem::is_directory(folder / "old")) << "it was not this command that made it";
}

}  // namespace
}  // namespace squat::commands
