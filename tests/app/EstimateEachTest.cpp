// squat estimate --each over passages as squat detect writes them: real searches, ended early.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "core/DurableFile.h"
#include "results/SampleResult.h"
#include "text/Csv.h"

namespace squat {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

TEST(EstimateEach, ExplainsThePassagesOfADetectionAndKeepsWhatIsDone) {
  const TemporaryFolder folder;
  const auto call = [&](const std::string& words) {
    return std::system(("cd '" + folder.path() + "' && '" + SQUAT_PROGRAM + "' " + words + " > said 2>&1").c_str());
  };
  const auto file = [&](const std::string& name) { return readWholeFile(folder / name, 10000000); };
  ASSERT_EQ(call("detect example-record --speed 30 --no-figures -o found"), 0);
  const std::string words = "estimate found/passages/squat-0001.csv --each --case light-defect --runs 20 -o out";
  ASSERT_EQ(call(words), 0) << file("said");
  const auto rows = text::csvRecords(file("out/estimates.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].at(1), "done");
  EXPECT_GT(std::stod(rows[1].at(2)), 0) << "depth";
  // The whole command estimates the same passage to the same depth: one path for both.
  ASSERT_EQ(call("estimate found/passages/squat-0001.csv --case light-defect --runs 20 -o single"), 0) << file("said");
  EXPECT_EQ(file("out/squat-0001/estimate.csv"), file("single/estimate.csv"));

  const auto written = std::filesystem::last_write_time(folder / "out/squat-0001/estimate.csv");
  const auto table = file("out/estimates.csv");
  ASSERT_EQ(call(words + " --partition slice:1/1"), 0);
  EXPECT_THAT(file("said"), HasSubstr("already done"));
  ASSERT_EQ(call(words + " --collect"), 0);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "out/squat-0001/estimate.csv"), written);
  EXPECT_EQ(file("out/estimates.csv"), table);
  EXPECT_NE(call(words + " --collect --low-pass 1500"), 0) << "of other options there is none";
  EXPECT_THAT(file("said"), HasSubstr("no estimates of found/passages/squat-0001.csv with the options of this call"));
}

}  // namespace
}  // namespace squat
