// A child process that reads files: what it sends, how it ends, and what happens where it never begins.
#include "results/GuardedChild.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/Errors.h"

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

TEST_F(Children, ThatDieAreAnError) {
  GuardedChild child("a.h5", impatient(), [](const ByteSink&) { ::raise(SIGSEGV); });
  EXPECT_THROW(child.receiveKind(), FileError);
}

}  // namespace
}  // namespace squat::results
