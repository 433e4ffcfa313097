#include "core/FolderLock.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "core/Errors.h"

namespace squat {
namespace {

class FolderLockTest : public testing::Test {
 protected:
  FolderLockTest() { std::filesystem::create_directories(folder_); }
  ~FolderLockTest() override { std::filesystem::remove_all(folder_); }
  std::string refusal() const {
    try {
      const FolderLock lock(folder_, "squat run other");
      return {};
    } catch (const CaseError& error) {
      return error.what();
    }
  }
  const std::string folder_ =
      (std::filesystem::temp_directory_path() / ("squat-lock-" + std::to_string(::getpid()))).string();
};

TEST_F(FolderLockTest, theOwnerOfTheFolderIsReportedToTheSecond) {
  {
    const FolderLock lock(folder_, "squat study light-defect");
    EXPECT_TRUE(lock.held());
    EXPECT_THAT(refusal(), testing::AllOf(testing::HasSubstr(folder_), testing::HasSubstr("squat study light-defect"),
                                          testing::HasSubstr(std::to_string(::getpid()))));
  }
  EXPECT_EQ(refusal(), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

// A process that is killed leaves its file, not its lock.
TEST_F(FolderLockTest, aKilledOwnerOwnsNothing) {
  const pid_t child = ::fork();
  if (child == 0) {
    const FolderLock lock(folder_, "squat run killed");
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(std::filesystem::is_empty(folder_));
  EXPECT_EQ(refusal(), "");
}

TEST_F(FolderLockTest, anotherProcessIsRefused) {
  std::optional<FolderLock> lock;
  lock.emplace(folder_, "squat run first");
  const pid_t child = ::fork();
  if (child == 0) ::_exit(refusal().find("squat run first") != std::string::npos ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace squat
