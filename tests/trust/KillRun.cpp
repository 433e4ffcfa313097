#include "trust/KillRun.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "trust/Program.h"
#include "trust/ShortCase.h"

namespace squat::tests {

namespace {

// Without what tells of machine and clock.
results::ArrayTree comparable(results::RunResult result) {
  result.performance.clear();
  result.threads = 0;
  result.created.clear();
  return results::toTree(result);
}

}  // namespace

void killAndResume(int kills) {
  const TemporaryFolder folder;
  const auto result = folder / "light-defect.h5", checkpoint = folder / "light-defect.checkpoint";
  const auto kept = folder / "undisturbed.h5";
  std::string output;
  ASSERT_EQ(call(shortRun(folder.path()), &output), 0) << output;
  std::filesystem::copy_file(result, kept);

  bool seen = false;
  unsigned random = 7;
  for (int kill = 0; kill < kills; ++kill) {
    Program program(shortRun(folder.path(), {"--checkpoint-every", "0.01"}));
    if (kill % 4 != 0) program.waitForOutput("rolling");
    random = random * 1664525U + 1013904223U;
    // The last kill comes with the first checkpoint: by the random moment a busy machine may not have written one, and
    // a fast one may be done and have removed it.
    if (kill < kills - 1) std::this_thread::sleep_for(std::chrono::milliseconds((random >> 8) % 1500));
    for (int wait = 0; kill == kills - 1 && !std::filesystem::exists(checkpoint) && wait < 6000; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    program.signal(SIGKILL);
    program.wait();
    ASSERT_TRUE(results::readResult(result).complete) << "after kill " << kill;
    if (std::filesystem::exists(checkpoint)) {
      seen = true;
      bool usedPrevious = true;
      ASSERT_TRUE(results::readCheckpoint(checkpoint, &usedPrevious).has_value());
      ASSERT_FALSE(usedPrevious) << "after kill " << kill;
    }
  }
  EXPECT_TRUE(seen) << "no checkpoint was ever written";
  std::filesystem::remove(result);  // else --resume finds the finished run and has nothing to do
  ASSERT_EQ(call(shortRun(folder.path(), {"--resume"}), &output), 0) << output;
  EXPECT_EQ(results::firstDifference(comparable(results::readResult(kept)), comparable(results::readResult(result))),
            "");
}

}  // namespace squat::tests
