// A growth that is killed between two blocks goes on with the same bits, and the program keeps what it should.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
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
    // A previous checkpoint: at least one block stands in the current one.
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

// A forecast grows the rail again with other inputs.
TEST(GrowthProgram, ForecastsBetweenLimits) {
  const TemporaryFolder folder;
  const std::vector<std::string> words{"grow",         "light-defect",
                                       "--mesh",       "tiny",
                                       "--set",        "motion.torque=0",
                                       "--set",        "growth.wheelsets=1",
                                       "--tonnage",    "0.001",
                                       "--threads",    "1",
                                       "--uncertain",  "defect.depth=0.10:0.20",
                                       "--growths",    "2",
                                       "--until",      "depth=0.16",
                                       "--no-figures", "-o",
                                       folder.path()};
  std::string output;
  ASSERT_EQ(call(words, &output), 0);
  // A depth from each half of the range; wear changes nothing that could be seen in 1,000 tonnes.
  EXPECT_THAT(output, HasSubstr("Forecast from 2 growths"));
  const auto table = bytesOf(folder / "light-defect-forecast.csv");
  const auto growths = bytesOf(folder / "light-defect-forecast/study.csv");
  double tonnage = 0, ground = 0, lowest = 0, median = 0, highest = 0;
  const auto last = table.substr(table.rfind('\n', table.size() - 2) + 1);
  ASSERT_EQ(std::sscanf(last.c_str(), "%lf,%lf,%lf,%lf,%lf", &tonnage, &ground, &lowest, &median, &highest), 5) << last;
  EXPECT_EQ(tonnage, 0.001);
  EXPECT_GT(lowest, 0.0999);
  EXPECT_LT(lowest, 0.1501);
  EXPECT_GT(highest, 0.1499);
  EXPECT_LT(highest, 0.2001);
  EXPECT_NEAR(median, 0.5 * (lowest + highest), 1e-9);

  // The table of growths stands: the forecast is put together again, and another one is refused before it is computed.
  ASSERT_EQ(call(words, &output), 0);
  EXPECT_THAT(output, HasSubstr("Forecast from 2 growths"));
  EXPECT_EQ(bytesOf(folder / "light-defect-forecast.csv"), table);
  EXPECT_EQ(bytesOf(folder / "light-defect-forecast/study.csv"), growths);
  auto other = words;
  *std::find(other.begin(), other.end(), "0.001") = "0.002";
  EXPECT_EQ(call(other, &output), 2);
  EXPECT_THAT(output, HasSubstr("The folder holds another forecast"));

  EXPECT_EQ(call({"grow", "light-defect", "--tonnage", "1", "--uncertain", "defect.depht=0.1:0.2"}, &output), 2);
  EXPECT_THAT(output, HasSubstr("defect.depth"));
  EXPECT_EQ(call({"grow", "light-defect", "--tonnage", "1", "--growths", "2"}, &output), 2);
  EXPECT_THAT(output, HasSubstr("--uncertain"));
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
