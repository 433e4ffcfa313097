// A program that reads files for this one: what it sends, how it ends, and that it ends with this one.
#include "results/GuardedChild.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/Errors.h"
#include "core/platform/Process.h"
#include "results/ArrayStream.h"

namespace squat::results {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path program = SQUAT_READER_OF_TESTS;

class Readers : public ::testing::Test {
 protected:
  Readers() { fs::create_directory(folder_); }
  ~Readers() override { fs::remove_all(folder_); }

  static GuardedChild reader(const ReaderCall& call, std::size_t seconds = 10) {
    return GuardedChild("a.h5", {std::size_t{64} << 20, seconds}, call, program);
  }
  static std::string errorOf(const ReaderCall& call) {
    try {
      reader(call, 1).receiveKind();
    } catch (const FileError& error) {
      return error.what();
    }
    return "no error";
  }
  const fs::path folder_ = fs::path(testing::TempDir()) / ("readers-" + std::to_string(::getpid()));
};

// More than a pipe or a socket holds, both ways.
TEST_F(Readers, SendWhatTheyAreAskedFor) {
  const std::string text(3 << 20, 'x');
  auto child = reader(ReaderCall{"echo"}.text(text));
  EXPECT_EQ(child.receiveKind(), 'k');
  std::string back(text.size() + 1, ' ');
  back.resize(child.receive(std::as_writable_bytes(std::span(back))));
  EXPECT_EQ(back, text);
}

TEST_F(Readers, PassOnTheErrorOfTheirWork) {
  try {
    reader({"refuse"}).receiveKind();
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_EQ(error.location(), "/signals");
    EXPECT_THAT(error.what(), HasSubstr("is cut off"));
  }
}

TEST_F(Readers, ThatDieAreAnError) { EXPECT_THAT(errorOf({"crash"}), HasSubstr("reading it was stopped")); }
TEST_F(Readers, ThatComputeForEverAreEnded) { EXPECT_THAT(errorOf({"compute for ever"}), HasSubstr("too long")); }
TEST_F(Readers, OfAnotherVersionAreAnError) { EXPECT_THAT(errorOf({"dance"}), HasSubstr("another version")); }

TEST_F(Readers, ThatAreMissingAreAnError) {
  EXPECT_THROW(GuardedChild("a.h5", {}, {"echo"}, folder_ / "missing"), FileError);
}

// A sanitizer reserves terabytes of addresses, so that the limit is left out there.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(Readers, TakeNoMoreMemoryThanAllowed) {
  EXPECT_EQ(reader(ReaderCall{"take memory"}.number(std::size_t{32} << 20)).receiveKind(), 'k');
  EXPECT_THAT(errorOf(ReaderCall{"take memory"}.number(std::size_t{1} << 30)), HasSubstr("more memory than allowed"));
}
#endif

TEST_F(Readers, WriteNoFile) {
  const auto path = folder_ / "written";
  errorOf(ReaderCall{"write a file"}.text(path.string()));
  EXPECT_TRUE(!fs::exists(path) || fs::file_size(path) == 0);
}

// Who asked is killed while its reader has more to send than a socket holds.
TEST_F(Readers, EndWhereWhoAskedIsKilled) {
  const pid_t asking = ::fork();
  if (asking == 0) {
    auto child = reader(ReaderCall{"say who and send much"}.text(folder_.string()));
    std::byte first{};
    child.receive(std::span(&first, 1));
    while (true) ::pause();
  }
  const auto within = [](const auto& holds) {
    for (int wait = 0; wait < 2000 && !holds(); ++wait) ::usleep(10000);  // 20 s: the machine may be busy
    return holds();
  };
  EXPECT_TRUE(within([&] { return !fs::is_empty(folder_); }));
  const auto process = std::stol(fs::directory_iterator(folder_)->path().filename().string());
  EXPECT_TRUE(platform::isRunning(process));
  ::kill(asking, SIGKILL);
  ::waitpid(asking, nullptr, 0);
  EXPECT_TRUE(within([&] { return !platform::isRunning(process); }));
}

TEST(ReaderCall, GivesItsArgumentsBack) {
  ReaderCall call{"work"};
  putColumns(call.text("\xc3\xa4").number(7), {{"/a", 1, 2, false}, {"", 0, 1, true}});
  ReaderArguments arguments(call.arguments);
  EXPECT_EQ(arguments.text(), "\xc3\xa4");
  EXPECT_EQ(arguments.number(), 7U);
  const auto columns = takeColumns(arguments);
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].path, "/a");
  EXPECT_EQ(columns[0].run, 1U);
  EXPECT_EQ(columns[0].runs, 2U);
  EXPECT_FALSE(columns[0].samplesFirst);
  EXPECT_TRUE(columns[1].samplesFirst);
  EXPECT_THROW(arguments.number(), std::out_of_range);
}

}  // namespace
}  // namespace squat::results
