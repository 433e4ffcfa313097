#include "analysis/FileComparison.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "analysis/ComparisonFiles.h"
#include "analysis/Folder.h"
#include "core/Errors.h"

namespace squat::analysis {
namespace {

using ::testing::HasSubstr;
using tests::Folder;
using tests::runTable;

TEST(FileComparison, computedBesideMeasured) {
  const Folder folder;
  const auto computed = folder.write("computed.csv", runTable(0.08, 60, 30));
  const auto measured = folder.write("measured.csv", runTable(0.1, 40, 29, 1000));
  const auto again = folder.write("again.csv", runTable(0.06, 30, 28));
  Monitor monitor;
  const auto pairs = compareFiles(computed, {measured, again}, {}, monitor);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NEAR(pairs[1].comparison.peakRatio, 2, 0.01);
  EXPECT_NEAR(pairs[1].comparison.correlation, 1, 1e-3);
  EXPECT_NEAR(pairs[1].comparison.shift, -0.02, 1 / 25000.0);
  EXPECT_LT(pairs[0].comparison.correlation, 0.99);
  writeComparisons(pairs, folder.path("out"));
  const std::string csv = folder.read("out/comparison.csv");
  EXPECT_THAT(csv, HasSubstr("first,second,peak ratio [-]"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/comparison.json")).at("pairs").size(), 2u);
  EXPECT_THAT(folder.read("out/measured_aba_overlay.csv"), HasSubstr("time [s],computed: aba [m/s2]"));
  EXPECT_THAT(folder.read("out/measured_aba_spectra.csv"), HasSubstr("ratio [-]"));
}

TEST(FileComparison, defectBesideSmooth) {
  const Folder folder;
  const auto defect = folder.write("defect.csv", runTable(0.08, 60, 30));
  const auto smooth = folder.write("smooth.csv", runTable(1.0, 60, 30));  // never struck
  FileComparisonOptions options;
  options.smooth = true;
  Monitor monitor;
  const auto pairs = compareFiles(defect, {smooth}, options, monitor);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].comparison.inPosition);
  EXPECT_EQ(pairs[0].comparison.shift, 0);
  EXPECT_NEAR(pairs[0].comparison.differencePeak, pairs[0].comparison.firstFeatures.peak, 0.05);
  for (const double ratio : pairs[0].comparison.bandRatio) EXPECT_GT(ratio, 1000);
}

TEST(FileComparison, neverReplacesWhatWasCompared) {
  const Folder folder;
  const auto text = runTable(0.08, 60, 30);
  const auto computed = folder.write("comparison.csv", text);
  const auto measured = folder.write("measured_aba_overlay.csv", runTable(0.1, 40, 29, 1000));
  Monitor monitor;
  const auto pairs = compareFiles(computed, {measured}, {}, monitor);
  EXPECT_THROW(writeComparisons(pairs, folder.path()), CaseError);
  EXPECT_EQ(folder.read("comparison.csv"), text);
  EXPECT_NO_THROW(writeComparisons(pairs, folder.path("out")));
}

TEST(FileComparison, refusesBadInput) {
  const Folder folder;
  const auto one = folder.write("one.csv", runTable(0.08, 60, 30));
  const auto gap = folder.write("gap.csv", "time;position;aba\n0;0;1\n1;1;2\n5;2;1\n6;3;1\n7;4;1\n");
  const auto two = folder.write("two.csv", "t,a,b\n0,1,2\n1,2,3\n2,3,4\n");
  Monitor monitor;
  EXPECT_THROW(compareFiles(one, {}, {}, monitor), CaseError);
  EXPECT_THROW(compareFiles(one, {gap}, {}, monitor), FileError);
  FileComparisonOptions options;
  options.first.column = "all";
  EXPECT_THROW(compareFiles(two, {one}, options, monitor), CaseError);
  EXPECT_THROW(compareFiles(folder.path("none.csv"), {one}, {}, monitor), FileError);
}

}  // namespace
}  // namespace squat::analysis
