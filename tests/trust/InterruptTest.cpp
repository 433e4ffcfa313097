// Signals and kills sent to the program while it rolls.
#include <gmock/gmock.h>
#include <signal.h>

#include <filesystem>

#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"
#include "trust/KillRun.h"
#include "trust/Program.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using ::testing::HasSubstr;
using tests::Program;
using tests::shortRun;
using tests::TemporaryFolder;

class Interrupt : public ::testing::TestWithParam<int> {};

TEST_P(Interrupt, OneSignalStopsCleanlyAndTheRunCanBeResumed) {
  const TemporaryFolder folder;
  const auto result = folder / "light-defect.h5";
  Program program(shortRun(folder.path()));
  ASSERT_TRUE(program.waitForOutput("rolling")) << program.output();
  program.signal(GetParam());
  EXPECT_EQ(program.wait(), 130) << program.output();
  const auto stopped = results::readResult(result);
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.stopReason, "cancelled");
  EXPECT_TRUE(results::readCheckpoint(folder / "light-defect.checkpoint").has_value());

  std::string output;
  EXPECT_EQ(tests::call(shortRun(folder.path(), {"--set", "motion.speed=29"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("checkpoint of another case"));
  EXPECT_EQ(tests::call(shortRun(folder.path(), {"--resume"}), &output), 0) << output;
  EXPECT_TRUE(results::readResult(result).complete);
  EXPECT_FALSE(std::filesystem::exists(folder / "light-defect.checkpoint"));
  EXPECT_EQ(tests::call(shortRun(folder.path(), {"--resume"}), &output), 0);
  EXPECT_THAT(output, HasSubstr("already complete"));
  EXPECT_EQ(tests::call(shortRun(folder.path(), {"--resume", "--set", "motion.speed=29"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("another case"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, ::testing::Values(SIGINT, SIGTERM));

// Nothing was recorded, so nothing can be resumed: no file and no empty folder is left, and the output says so.
TEST(InterruptEarly, LeavesNothingAndPromisesNothing) {
  const TemporaryFolder folder;
  Program program(shortRun(folder / "new/out"));
  ASSERT_TRUE(program.waitForOutput("mesh")) << program.output();
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130) << program.output();
  EXPECT_THAT(program.output(), HasSubstr("cancelled: nothing recorded, no file written"));
  EXPECT_THAT(program.output(), HasSubstr("no checkpoint to resume from"));
  EXPECT_THAT(program.output(), ::testing::Not(HasSubstr("written:")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// The folder that a command makes for its files goes again where it wrote none.
TEST(InterruptEarly, NoCommandLeavesAnEmptyFolder) {
  struct Call {
    std::vector<std::string> words;
    std::string firstPhase;
  };
  for (const auto& [words, firstPhase] : {Call{{"validate"}, "mesh"}, Call{{"figures", "paper"}, "mesh"},
                                          Call{{"receptance", "light-defect"}, "receptance"}}) {
    const TemporaryFolder folder;
    auto call = words;
    for (const auto& word : {std::string("--mesh"), std::string("tiny"), std::string("-o"), folder / "new/out"})
      call.push_back(word);
    Program program(call);
    if (!program.waitForOutput(firstPhase)) {
      EXPECT_THAT(program.output(), HasSubstr("headless build"));
      continue;
    }
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 130) << program.output();
    EXPECT_THAT(program.output(), HasSubstr("cancelled: "));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << words.front();
  }
}

// The second signal is another one: two of a kind that come at once are one to the kernel. A clean stop would leave a
// result that is marked unfinished; a second signal leaves nothing. A second is promised, looked for in processor time:
// the wall clock would tell of the machine's other work.
TEST(InterruptTwice, IsOutWithinASecond) {
  const TemporaryFolder folder;
  Program program(shortRun(folder.path()));
  ASSERT_TRUE(program.waitForOutput("equilibrium")) << program.output();
  const double before = program.processorSeconds();
  program.signal(SIGINT);
  program.signal(SIGTERM);
  EXPECT_EQ(program.wait(), 130) << program.output();
  EXPECT_LT(program.processorSeconds() - before, 1.0);
  EXPECT_FALSE(std::filesystem::exists(folder / "light-defect.h5"));
}

TEST(KillRun, AFewMomentsLoseNothing) { tests::killAndResume(4); }

}  // namespace
}  // namespace squat
