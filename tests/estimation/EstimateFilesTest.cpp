// The files of an estimate.
#include "estimation/EstimateFiles.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "case/ParameterTable.h"
#include "core/DurableFile.h"
#include "results/SampleResult.h"

namespace squat::estimation {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

Estimate sample() {
  Estimate estimate;
  estimate.complete = true;
  estimate.depth = {1e-4, 0.9e-4, 1.2e-4};
  estimate.profile = {{-0.01, 0, 0, 0, true}, {0, -1e-4, -1.2e-4, -0.9e-4, false}, {0.01, 0, 0, 0, true}};
  estimate.passages.push_back({"run.csv: aba", 30, 12.5, 1, 2, 80, {}, {}, {}});
  estimate.description = cases::defaultCase();
  estimate.description.defect.shape = cases::DefectShape::profile;
  estimate.description.motion.speed = 27;
  return estimate;
}

TEST(EstimateFiles, TheTableHasTheColumnsThatOthersRead) {
  const TemporaryFolder folder;
  writeEstimate(sample(), folder.path());
  EXPECT_EQ(readWholeFile(folder / "estimate.csv", 10000),
            "position [mm],height [um],lower [um],upper [um],felt\n"
            "-10,0,0,0,1\n0,-100,-120,-90,0\n10,0,0,0,1\n");
}

TEST(EstimateFiles, TheCaseReadsItsProfile) {
  const TemporaryFolder folder;
  writeEstimate(sample(), folder.path());
  const auto text = readWholeFile(folder / "estimate.toml", 1000000);
  EXPECT_THAT(text, HasSubstr("file = \"estimate-profile.csv\""));
  const auto read = cases::readCase(folder / "estimate.toml");
  EXPECT_EQ(read.motion.speed, 27);
  ASSERT_EQ(read.defect.points.size(), 3U);
  EXPECT_NEAR(read.defect.points[1].height, -1e-4, 1e-12);  // rounding
}

TEST(EstimateFiles, TheJsonIsWrittenAsItIsPrinted) {
  const TemporaryFolder folder;
  writeEstimate(sample(), folder.path());
  EXPECT_EQ(readWholeFile(folder / "estimate.json", 1000000), estimateJson(sample()));
}

TEST(EstimateFiles, TheJsonSaysTheSame) {
  const auto json = nlohmann::json::parse(estimateJson(sample()));
  EXPECT_EQ(json["schema"], "squat-estimate");
  EXPECT_NEAR(json["depth_um"]["high"].get<double>(), 120, 1e-9);
  EXPECT_EQ(json["profile"].size(), 3U);
  EXPECT_EQ(json["profile"][1]["felt"], false);
  EXPECT_EQ(json["passages"][0]["position"], 12.5);
}

}  // namespace
}  // namespace squat::estimation
