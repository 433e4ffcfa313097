// What the platform layer promises, on the system that this runs on.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "TemporaryFolder.h"
#include "core/platform/ChildProgram.h"
#include "core/platform/Clock.h"
#include "core/platform/CommandOutput.h"
#include "core/platform/Cores.h"
#include "core/platform/File.h"
#include "core/platform/Memory.h"
#include "core/platform/OwnFolder.h"
#include "core/platform/Process.h"
#include "core/platform/ProgramPath.h"
#include "core/platform/Threads.h"

namespace squat::platform {
namespace {

namespace fs = std::filesystem;

class PlatformLayer : public ::testing::Test {
 protected:
  tests::TemporaryFolder folder_;
};

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST_F(PlatformLayer, aFileIsWrittenAndReadAgain) {
  const std::string path = folder_ / "file", text = "one line\n";
  {
    File file(path, File::Access::replace);
    ASSERT_FALSE(file.openingError());
    EXPECT_FALSE(file.write(bytesOf(text)));
    EXPECT_FALSE(file.flush());
    EXPECT_FALSE(file.close());
  }
  flushFolder(folder_.path());
  File file(path, File::Access::read);
  std::error_code error;
  EXPECT_TRUE(file.state(error).isRegular);
  EXPECT_EQ(file.state(error).size, text.size());
  std::string all(100, ' '), tail(5, ' ');
  EXPECT_EQ(file.read(std::as_writable_bytes(std::span(all)), error), text.size());
  EXPECT_EQ(file.read(std::as_writable_bytes(std::span(all)), error), 0U);
  EXPECT_FALSE(error);
  EXPECT_TRUE(file.readAt(4, std::as_writable_bytes(std::span(tail))));
  EXPECT_EQ(tail, "line\n");
  EXPECT_FALSE(file.readAt(5, std::as_writable_bytes(std::span(tail))));
}

TEST_F(PlatformLayer, whatIsNoFileIsAnError) {
  const File none(folder_ / "none", File::Access::read);
  EXPECT_EQ(none.openingError(), std::errc::no_such_file_or_directory);
  EXPECT_FALSE(mayRead(folder_ / "none"));
  File folder(folder_.path(), File::Access::read);
  std::error_code error;
  EXPECT_FALSE(folder.state(error).isRegular);
  std::string some(1, ' ');
  EXPECT_EQ(folder.read(std::as_writable_bytes(std::span(some)), error), 0U);
  EXPECT_EQ(error, std::errc::is_a_directory);
  EXPECT_FALSE(isLackOfRoom(error));
  EXPECT_TRUE(isLackOfRoom(std::make_error_code(std::errc::no_space_on_device)));
}

TEST_F(PlatformLayer, anOwnFolderIsNewEachTime) {
  const auto one = makeOwnFolder(folder_ / "own"), other = makeOwnFolder(folder_ / "own");
  EXPECT_TRUE(fs::is_directory(one));
  EXPECT_NE(one, other);
  EXPECT_TRUE(makeOwnFolder(folder_ / "none/own").empty());
}

TEST(ThisProcess, isKnown) {
  EXPECT_TRUE(isRunning(processNumber()));
  EXPECT_NE(processName("test").find(std::to_string(processNumber()) + " on " + hostName()), std::string::npos);
  EXPECT_FALSE(isAlive("1-1-00000000"));
  EXPECT_TRUE(fs::exists(programPath()));
  EXPECT_TRUE(ownLibrary().empty());
  EXPECT_GT(peakMemory(), 1e6);
}

TEST(ThisMachine, isKnown) {
  EXPECT_GT(availableMemory(), 0);
  EXPECT_GE(usableCores(), 1);
  EXPECT_GE(lastLevelCache(), 0);
}

TEST(ThisThread, hasATimeOfItsOwn) {
  const auto before = processorTime();
  while (processorTime() == before) pauseOfAWait();
  EXPECT_GE(timesCoreWasLost(), 0);
}

TEST(CommandOutput, isWhatACommandPrints) {
  const auto done = outputOfCommand("echo one; echo two >&2; echo three");
  EXPECT_TRUE(done.isStarted && done.isDone);
  EXPECT_EQ(done.text, "one\nthree\n");
  const auto failed = outputOfCommand("echo one; exit 3");
  EXPECT_TRUE(failed.isStarted);
  EXPECT_FALSE(failed.isDone);
  EXPECT_EQ(failed.text, "one\n");
}

TEST(UtcDate, ofTheFirstSecondOf2020) {
  const auto date = utcDate(1577836800);  // 50 years with 12 leap days: 18262 days of 86400 s
  EXPECT_EQ(date.tm_year, 120);
  EXPECT_EQ(date.tm_yday, 0);
  EXPECT_EQ(date.tm_hour, 0);
}

// The shell is asked, and its standard output comes here.
ChildProgram& asked(ChildProgram& child, const std::string& question) {
  const auto error = child.start("/bin/sh", bytesOf(question));
  EXPECT_FALSE(error) << error.message();
  return child;
}

TEST(ChildProgram, sendsWhatItIsAskedFor) {
  ChildProgram child;
  std::string text(100, ' ');
  text.resize(asked(child, "printf found").receive(std::as_writable_bytes(std::span(text))));
  EXPECT_EQ(text, "found");
  child.waitForEnd();
  EXPECT_TRUE(child.hasEnded());
  EXPECT_FALSE(child.wasStopped());
}

TEST(ChildProgram, isEndedWhereItSendsNothing) {
  ChildProgram child;
  asked(child, "exec sleep 3600");
  EXPECT_FALSE(child.hasEnded());
  child.kill();
  EXPECT_TRUE(child.hasEnded());
  EXPECT_TRUE(child.wasStopped());
}

// One that ends without reading: writing to it must not end this process.
TEST(ChildProgram, mayEndBeforeItHasReadItsQuestion) {
  ChildProgram child;
  asked(child, "exit 0\n" + std::string(4 << 20, '#'));
  child.waitForEnd();
  EXPECT_FALSE(child.wasStopped());
}

TEST(ChildProgram, isNoneWhereItDoesNotStart) {
  ChildProgram child;
  EXPECT_TRUE(child.start("/no/such/program", {}));
  EXPECT_TRUE(child.hasEnded());
}

// Locks are files that the program must not hold on.
TEST_F(PlatformLayer, aChildProgramInheritsNoFile) {
  File file(folder_ / "file", File::Access::replace);
  ChildProgram child;
  std::string text(1000, ' ');
  text.resize(asked(child, "ls -l /proc/self/fd").receive(std::as_writable_bytes(std::span(text))));
  EXPECT_EQ(text.find("/file"), std::string::npos) << text;
}

}  // namespace
}  // namespace squat::platform
