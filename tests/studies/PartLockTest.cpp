#include "studies/PartLock.h"

#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "studies/CollectParts.h"
#include "studies/StubStudy.h"

namespace squat::studies {
namespace {

using squat::tests::TemporaryFolder;
using std::chrono::milliseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr milliseconds kBeat{50};
const std::string kElsewhere = "squat study --partition slice:1/2 (process 4711 on elsewhere)\n";

class PartLockTest : public ::testing::Test {
 protected:
  std::string path() const { return folder_ / "study-slice-1-of-2.lock"; }
  std::string refusal() {
    try {
      const PartLock lock("study", partitionFromText("slice:1/2"), folder_.path(), kBeat, monitor_);
    } catch (const CaseError& error) {
      return error.what();
    }
    return "accepted";
  }
  const TemporaryFolder folder_;
  struct Listener : Monitor {
    void message(const std::string& text) override { heard += text + "\n"; }
    std::string heard;
  } monitor_;
};

TEST_F(PartLockTest, theOwnerOfThePartIsReportedToTheSecond) {
  {
    const PartLock lock("study", partitionFromText("slice:1/2"), folder_.path(), kBeat, monitor_);
    EXPECT_THAT(refusal(), AllOf(HasSubstr("slice:1/2"), HasSubstr("process " + std::to_string(::getpid()))));
    EXPECT_NO_THROW(PartLock("study", partitionFromText("slice:2/2"), folder_.path(), kBeat, monitor_));
    std::this_thread::sleep_for(3 * kBeat);
    EXPECT_THAT(readWholeFile(path(), 1000), HasSubstr("\nbeat "));
    EXPECT_NO_THROW(lock.requireOwn());
  }
  EXPECT_FALSE(std::filesystem::exists(path()));
  EXPECT_EQ(monitor_.heard, "");
}

// What a file system looks like that keeps flock() to each machine: the other's text stands there, and no lock is felt.
TEST_F(PartLockTest, anotherMachineThatStillBeatsIsNoticed) {
  writeDurably(path(), kElsewhere + "beat 1\n");
  std::jthread other([&] {
    std::this_thread::sleep_for(kBeat);
    writeDurably(path(), kElsewhere + "beat 2\n");
  });
  EXPECT_THAT(refusal(), HasSubstr("process 4711 on elsewhere"));
  other.join();
  EXPECT_TRUE(std::filesystem::exists(path())) << "its file stays";
}

TEST_F(PartLockTest, anotherMachineThatHasDiedIsFollowed) {
  writeDurably(path(), kElsewhere + "beat 1\n");
  EXPECT_EQ(refusal(), "accepted");
  EXPECT_THAT(monitor_.heard, HasSubstr("begun by squat study --partition slice:1/2 (process 4711 on elsewhere)"));
}

// Both started within one moment: the first notices before it writes its next row, and what it has stays.
TEST_F(PartLockTest, aPartThatWasTakenOverStops) {
  const auto study = stubStudy(3, 3);
  auto options = partOptions(folder_.path(), "slice:1/2");
  options.beat = kBeat;
  int runs = 0;
  const StudyRunner run = [&](const StudyPoint& point, Monitor& monitor) {
    if (++runs == 3) writeDurably(path(), kElsewhere + "beat 0\n");
    return stubRun(point, monitor);
  };
  EXPECT_THROW(runStudy(study, run, options, monitor_), CaseError);
  EXPECT_EQ(runs, 3);
  EXPECT_EQ(collectParts(study, folder_.path()).parts[0].done, 2U);
}

}  // namespace
}  // namespace squat::studies
