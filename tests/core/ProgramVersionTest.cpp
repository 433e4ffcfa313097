// What warm states, studies and results are compared by holds no commit; what people read names it.
#include "core/ProgramVersion.h"

#include <gmock/gmock.h>

#include <regex>

namespace squat {
namespace {

TEST(ProgramVersion, IsThatOfTheProjectAndThreeNumbers) {
  EXPECT_STREQ(programVersion(), PROJECT_VERSION);
  EXPECT_TRUE(std::regex_match(programVersion(), std::regex(R"(\d+\.\d+\.\d+)"))) << programVersion();
}

TEST(ProgramVersion, TextNamesTheCommitWhereItIsKnown) {
  const std::string commit = programCommit();
  EXPECT_TRUE(std::regex_match(commit, std::regex("([0-9a-f]{12}(-changed)?)?"))) << commit;
  const std::string expected = commit.empty() ? PROJECT_VERSION : PROJECT_VERSION " (commit " + commit + ")";
  EXPECT_EQ(programVersionText(), expected);
}

}  // namespace
}  // namespace squat
