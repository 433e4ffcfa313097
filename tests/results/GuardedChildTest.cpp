// A child process that reads files: what it sends, how it ends, and what happens where it never begins.
#include "results/GuardedChild.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/Errors.h"
#include "core/platform/FileLock.h"

namespace squat::results {
namespace {

namespace fs = std::filesystem;

class Children : public ::testing::Test {
 protected:
  Children() { fs::remove(begun_); }
  ~Children() override { fs::remove(begun_); }

  // The first child sleeps without a byte, as one does that waits for a lock which nobody will give back.
  GuardedChild::Work stuckOnce() const {
    return [begun = begun_](const ByteSink& send) {
      if (!fs::exists(begun)) {
        std::ofstream(begun).flush();  // its size stays zero: children may not write
        while (true) ::pause();
      }
      const std::byte kind{'k'};
      send(std::span(&kind, 1));
    };
  }
  static ChildLimits impatient() {
    ChildLimits limits;
    limits.memory = std::size_t{64} << 20, limits.patience = 200;
    return limits;
  }
  const fs::path begun_ = fs::path(testing::TempDir()) / ("begun-" + std::to_string(::getpid()));
};

TEST_F(Children, AreReplacedWhereTheyAreStuckBeforeTheFirstByte) {
  GuardedChild child("a.h5", impatient(), stuckOnce());
  EXPECT_EQ(child.receiveKind(), 'k');
  EXPECT_TRUE(fs::exists(begun_)) << "the first one had begun";
}

// A file that takes long: the one child that was started sends its byte after four times the patience.
TEST_F(Children, AreNotReplacedWhileTheyCompute) {
  auto limits = impatient();
  limits.patience = 1000, limits.seconds = 30;
  const fs::path folder = begun_.string() + "-each";
  fs::create_directory(folder);
  GuardedChild child("a.h5", limits, [&](const ByteSink& send) {
    std::ofstream(folder / std::to_string(::getpid())).flush();
    while (std::clock() < 4 * CLOCKS_PER_SEC) {
    }
    const std::byte kind{'k'};
    send(std::span(&kind, 1));
  });
  EXPECT_EQ(child.receiveKind(), 'k');
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1) << "children that began";
  fs::remove_all(folder);
}

TEST_F(Children, PassOnTheErrorOfTheirWork) {
  GuardedChild child("a.h5", impatient(), [](const ByteSink&) { throw FileError("a.h5", "/signals", "is cut off"); });
  try {
    child.receiveKind();
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_EQ(error.location(), "/signals");
  }
}

// The reader is killed while its child has more to send than a pipe holds (64 KiB, pipe(7)). A child that lived on
// would hold the lock that it was forked with, and no other process could use the folder.
TEST_F(Children, EndWhereTheirReaderIsKilled) {
  const std::string path = begun_.string() + "-lock";
  const pid_t reader = ::fork();
  if (reader == 0) {
    const platform::FileLock lock(path);
    GuardedChild child("a.h5", impatient(), [](const ByteSink& send) { send(std::vector<std::byte>(1 << 20)); });
    std::byte first{};
    child.receive(std::span(&first, 1));
    std::ofstream(begun_).flush();
    while (true) ::pause();
  }
  const auto within = [](const auto& holds) {
    for (int wait = 0; wait < 2000 && !holds(); ++wait) ::usleep(10000);  // 20 s: the machine may be busy
    return holds();
  };
  EXPECT_TRUE(within([&] { return fs::exists(begun_); }));
  EXPECT_TRUE(platform::FileLock(path).isTaken());
  ::kill(reader, SIGKILL);
  ::waitpid(reader, nullptr, 0);
  EXPECT_TRUE(within([&] { return platform::FileLock(path).held(); }));
  fs::remove(path);
}

TEST_F(Children, ThatDieAreAnError) {
  GuardedChild child("a.h5", impatient(), [](const ByteSink&) { ::raise(SIGSEGV); });
  EXPECT_THROW(child.receiveKind(), FileError);
}

}  // namespace
}  // namespace squat::results
