#include "case/CaseDescription.h"
#include "studies/SampledPoints.h"

#include <gmock/gmock.h>

#include <set>

#include "FixtureCase.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "studies/CaseStudy.h"
#include "studies/InputRange.h"

namespace squat::studies {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::set<std::pair<std::size_t, std::size_t>> cellsOf(const std::vector<std::vector<double>>& points, std::size_t x,
                                                      std::size_t rows, std::size_t y, std::size_t columns) {
  std::set<std::pair<std::size_t, std::size_t>> cells;
  for (const auto& point : points)
    cells.emplace(static_cast<std::size_t>(point[x] * static_cast<double>(rows)),
                  static_cast<std::size_t>(point[y] * static_cast<double>(columns)));
  return cells;
}

// I. M. Sobol', 1967: the first two coordinates are a (0, m, 2) net in base 2. Of 2^m points, each box of 2^-a by
// 2^-(m - a) holds exactly one; of any other coordinate, each interval of 2^-m. The digital shift keeps that.
TEST(SampledPoints, sobolPointsFillEveryBoxOnce) {
  for (const std::uint64_t seed : {1, 2, 77}) {
    const auto points = sobolPoints(256, 5, seed);
    for (std::size_t rows = 1; rows <= 256; rows *= 2)
      EXPECT_EQ(cellsOf(points, 0, rows, 1, 256 / rows).size(), 256U) << rows << " rows, seed " << seed;
    for (std::size_t d = 2; d < 5; ++d) EXPECT_EQ(cellsOf(points, d, 256, d, 1).size(), 256U);
  }
}

TEST(SampledPoints, latinHypercubeFillsEveryIntervalOnce) {
  const auto points = latinHypercubePoints(200, 4, 3);
  for (std::size_t d = 0; d < 4; ++d) EXPECT_EQ(cellsOf(points, d, 200, d, 1).size(), 200U);
}

TEST(SampledPoints, theSeedDecides) {
  EXPECT_EQ(sobolPoints(8, 3, 5), sobolPoints(8, 3, 5));
  EXPECT_NE(sobolPoints(8, 3, 5), sobolPoints(8, 3, 6));
  EXPECT_EQ(latinHypercubePoints(8, 3, 5), latinHypercubePoints(8, 3, 5));
  EXPECT_NE(latinHypercubePoints(8, 3, 5), latinHypercubePoints(8, 3, 6));
  const auto few = sobolPoints(8, 3, 5), more = sobolPoints(16, 3, 5);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin())) << "a longer sample begins with the shorter one";
}

TEST(SampledPoints, lieBetweenTheLimits) {
  const auto variations = sampledVariations({"defect.length=20:60", "pad.stiffness=200:2000"}, "sobol:64", 1);
  ASSERT_EQ(variations.size(), 2U);
  EXPECT_EQ(variations[1].key, "pad.stiffness");
  for (const auto& value : variations[0].values) {
    EXPECT_GT(std::stod(value), 20);
    EXPECT_LT(std::stod(value), 60);
  }
  EXPECT_EQ(std::set<std::string>(variations[0].values.begin(), variations[0].values.end()).size(), 64U);
}

TEST(SampledPoints, mayBeOfTheRightSide) {
  const auto ranges = inputRangesFromText({"pad.stiffness=200:2000", "right.pad.stiffness=300:900"}, "--free");
  EXPECT_EQ(sampledVariations({"right.pad.stiffness=300:900"}, "sobol:8", 1).front().key, "right.pad.stiffness");
  const auto whole = cases::parseCase(
      "[model]\nextent = \"whole\"\n[pad]\nstiffness = 1200\n[right.pad]\nstiffness = 700\n", "a case");
  EXPECT_EQ(ranges[0].valueIn(whole), 1200);
  EXPECT_EQ(ranges[1].valueIn(whole), 700);
  EXPECT_THROW(inputRangesFromText({"right.motion.speed=20:30"}, "--free"), CaseError);
  EXPECT_THROW(inputRangesFromText({"right.pad.stiffness=300:9e9"}, "--free"), CaseError);
}

TEST(SampledPoints, wrongCallsAreNamed) {
  const std::vector<std::string> range{"defect.length=20:60"};
  for (const auto* bad : {"", "sobol", "sobol:", "sobol:1", "sobol:10001", "sobol:8x", "halton:8"})
    EXPECT_THROW(sampledVariations(range, bad, 1), CaseError) << bad;
  for (const auto* bad :
       {"defect.length=20:60:5", "defect.length=60:20", "defect.length", "defect.lateral=uniform:cut"})
    EXPECT_THROW(sampledVariations({bad}, "sobol:8", 1), CaseError) << bad;
}

class PointsFile : public ::testing::Test {
 protected:
  std::vector<Variation> read(const std::string& text) const {
    writeDurably(folder_ / "points.csv", std::string_view(text));
    return variationsFromFile(folder_ / "points.csv");
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "accepted";
  }
  const TemporaryFolder folder_;
};

TEST_F(PointsFile, rowByRow) {
  const auto variations = read("defect.depth, defect.lateral\r\n0.1,uniform\r\n0.1,parabolic\r\n0.2,uniform\r\n");
  ASSERT_EQ(variations.size(), 2U);
  EXPECT_THAT(variations[0].values, ElementsAre("0.1", "0.1", "0.2"));
  StudyDefinition definition{"c", "h", variations};
  definition.isList = true;
  const auto points = gridOf(definition);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_THAT(points[1].values, ElementsAre("0.1", "parabolic"));
}

TEST_F(PointsFile, whatIsNoneIsNamed) {
  EXPECT_THAT(refusal(""), HasSubstr("no points"));
  EXPECT_THAT(refusal("defect.depth\n"), HasSubstr("no points"));
  EXPECT_THAT(refusal("defect.depth,pad.stiffness\n0.1,200\n0.1\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusal("defect.depth\n0.1\n0.2\n0.1\n"), HasSubstr("holds the point of line 2"));
}

TEST_F(PointsFile, isAStudy) {
  writeDurably(folder_ / "points.csv", std::string_view("motion.speed,defect.depth\n28,0.1\n30,0.12\n"));
  const cases::CaseOverrides overrides{"", {{"defect.shape", "cosine"}}};
  StudyRequest request;
  request.pointsFile = folder_ / "points.csv";
  const auto definition = studyOf(tests::fixtureCase("light-defect"), overrides, request);
  EXPECT_EQ(gridOf(definition).size(), 2U);
  EXPECT_DOUBLE_EQ(caseAt(definition, overrides, gridOf(definition)[1]).defect.depth, 1.2e-4);
  writeDurably(folder_ / "points.csv", std::string_view("motion.sped\n28\n"));
  EXPECT_THROW(studyOf(tests::fixtureCase("light-defect"), overrides, request), CaseError);
  // A list is not the grid of the same values.
  Monitor monitor;
  const StudyRunner run = [](const StudyPoint&, Monitor&) {
    return std::optional<FeatureRow>(FeatureRow{{"peak", 1}});
  };
  runStudy(definition, run, {folder_ / "out", 1, false}, monitor);
  auto grid = definition;
  grid.isList = false;
  EXPECT_THROW(runStudy(grid, run, {folder_ / "out", 1, false}, monitor), CaseError);
}

}  // namespace
}  // namespace squat::studies
