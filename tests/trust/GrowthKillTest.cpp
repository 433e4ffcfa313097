// A growth that is killed between two blocks goes on with the same bits, and the program keeps what it should.
#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "TemporaryFolder.h"
#include "trust/Program.h"

namespace squat::tests {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> growthInto(const std::string& folder, std::vector<std::string> besides = {}) {
  std::vector<std::string> words{"grow",         "light-defect",
                                 "--mesh",       "tiny",
                                 "--set",        "motion.torque=0",
                                 "--set",        "growth.wheelsets=1",
                                 "--set",        "rail.preset=R260",
                                 "--set",        "mesh.zone_before=70",
                                 "--set",        "mesh.zone_behind=110",
                                 "--tonnage",    "0.0002",
                                 "--threads",    "1",
                                 "--no-figures", "-o",
                                 folder};
  words.insert(words.end(), besides.begin(), besides.end());
  return words;
}

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

TEST(GrowthProgram, KilledAndResumedItHasTheSameBits) {
  const TemporaryFolder folder;
  ASSERT_EQ(call(growthInto(folder / "whole")), 0);
  {
    Program killed(growthInto(folder / "killed"));
    ASSERT_TRUE(killed.waitForOutput("0.00 Mt"));
    // The second line of a stage: at least one block stands in the checkpoint.
    while (killed.running() && !fs::exists(folder / "killed/light-defect-growth.checkpoint.previous")) {
    }
    killed.signal(SIGKILL);
    killed.wait();
  }
  ASSERT_TRUE(fs::exists(folder / "killed/light-defect-growth.checkpoint"));
  std::string output;
  // Not unasked over the work of hours.
  EXPECT_EQ(call(growthInto(folder / "killed"), &output), 2);
  EXPECT_THAT(output, HasSubstr("--resume"));
  ASSERT_EQ(call(growthInto(folder / "killed", {"--resume"})), 0);
  EXPECT_FALSE(fs::exists(folder / "killed/light-defect-growth.checkpoint"));
  for (const char* name : {"light-defect-growth.csv", "light-defect-growth.h5", "light-defect-grown.toml"})
    EXPECT_EQ(bytesOf(folder / ("killed/" + std::string(name))), bytesOf(folder / ("whole/" + std::string(name))))
        << name;
}

TEST(GrowthProgram, SaysWhatIsWrongWithACall) {
  const TemporaryFolder folder;
  std::string output;
  EXPECT_EQ(call({"grow", "light-defect", "-o", folder.path()}, &output), 2);
  EXPECT_THAT(output, HasSubstr("--tonnage"));
  EXPECT_EQ(call(growthInto(folder.path(), {"--grind", "0.2"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("0.2@10Mt"));
  EXPECT_EQ(call(growthInto(folder.path(), {"--until", "0.5"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("depth=0.5"));
}

}  // namespace
}  // namespace squat::tests
