// kill -9 at random moments while results and checkpoints are written: what stands under the final names is whole and
// not older than what was there when the last writing was finished.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <new>
#include <thread>

#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"

namespace squat::results {
namespace {

using tests::sampleResult;
using tests::TemporaryFolder;

// Shared by writer and test: numbers of the last result and checkpoint that are surely on disk.
struct Written {
  std::atomic<int> result{0}, checkpoint{0};
};

ArrayTree stateNumber(int number) {
  ArrayTree state;
  state.addScalar("/step", number, "1");
  state.add("/displacement", std::vector<double>(50000, number), "m");
  return state;
}

[[noreturn]] void writeForEver(const std::string& folder, Written& written) {
  auto result = sampleResult(20000);
  for (int number = written.result + 1;; ++number) {
    result.speed = number;
    writeResult(folder + "/run.h5", result);
    written.result = number;
    writeCheckpoint(folder + "/run.checkpoint", stateNumber(number));
    written.checkpoint = number;
  }
}

double stepOf(const ArrayTree& state) { return std::get<std::vector<double>>(state.find("/step")->values).at(0); }

constexpr int kKills = 50;

TEST(Kill, AtAnyMomentLeavesWholeFiles) {
  const TemporaryFolder folder;
  auto* written =
      new (::mmap(nullptr, sizeof(Written), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Written;
  writeResult(folder / "run.h5", sampleResult());
  writeCheckpoint(folder / "run.checkpoint", stateNumber(0));
  unsigned random = 20140101;
  for (int kill = 0; kill < kKills; ++kill) {
    const pid_t child = ::fork();
    if (child == 0) writeForEver(folder.path(), *written);
    random = random * 1664525U + 1013904223U;
    // Every fifth writer is let finish something first, however slow the machine is.
    const int before = written->checkpoint;
    for (int wait = 0; kill % 5 == 4 && written->checkpoint == before && wait < 30000; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::microseconds(1000 + (random >> 8) % 60000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    const auto result = readResult(folder / "run.h5");
    EXPECT_TRUE(result.complete);
    if (written->result > 0) {
      EXPECT_GE(result.speed, written->result.load());
    }
    bool usedPrevious = true;
    const auto state = readCheckpoint(folder / "run.checkpoint", &usedPrevious);
    ASSERT_TRUE(state.has_value());
    EXPECT_FALSE(usedPrevious) << "the newest checkpoint itself is whole";
    EXPECT_GE(stepOf(*state), written->checkpoint.load());
    written->result = std::max(written->result.load(), written->checkpoint.load());
  }
  EXPECT_GT(written->checkpoint, 0) << "nothing was ever finished: the test saw only the beginning";
  // What killed writers left beside is swept by the next one that lives.
  writeResult(folder / "run.h5", sampleResult());
  writeCheckpoint(folder / "run.checkpoint", stateNumber(1));
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("run.h5", "run.checkpoint", "run.checkpoint.previous"));
  ::munmap(written, sizeof(Written));
}

}  // namespace
}  // namespace squat::results
