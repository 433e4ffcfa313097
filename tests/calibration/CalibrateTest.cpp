// Calibrations of a few seconds, on real runs.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <set>

#include "calibration/CalibratedCase.h"
#include "calibration/Calibration.h"
#include "case/CaseDescription.h"
#include "case/ParameterValue.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::calibration {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

CalibrationOptions optionsFor(const TemporaryFolder& folder) {
  CalibrationOptions options;
  options.folder = folder.path(), options.jobs = 2, options.threads = 1;
  return options;
}

// A peak of the light defect that a depth between 0.05 and 0.25 mm gives (it is about 90 m/s2 at 0.15 mm): the depth
// is the only input, so that one run-up serves all points.
CalibrationDefinition depthFor(const TemporaryFolder& folder, double peak, double tolerance) {
  const auto path = folder / "targets.json";
  std::ofstream(path) << R"({"schema": "squat-targets", "schema_version": 1, "statements": [{"statement": "peak",
      "measure": "maximum", "expected": )"
                      << peak << R"(, "tolerance": )" << tolerance << R"(, "unit": "m/s2"}]})";
  CalibrationDefinition definition;
  definition.caseName = "light-defect";
  // The peak comes within the first 50 mm behind the edge: shorter runs have the same one.
  definition.overrides.values = {{"motion.run_up", "0.06"}, {"motion.beyond", "0.12"}};
  definition.inputs = freeInputsFromText({"defect.depth=0.05:0.25"});
  definition.targets = readTargets({path}, definition.caseName);
  definition.confirmMesh = "tiny";
  definition.evaluations = 14;
  return definition;
}

TEST(Calibrate, FindsADepthThatGivesThePeak) {
  const TemporaryFolder folder;
  Monitor monitor;
  const auto found = calibrate(depthFor(folder, 70, 0.1), optionsFor(folder), monitor);
  ASSERT_TRUE(found.complete);
  const auto& best = found.evaluations[found.best];
  ASSERT_TRUE(best.targets[0].value);
  EXPECT_NEAR(*best.targets[0].value, 70, 7);
  EXPECT_TRUE(found.outOfReach.empty());
  ASSERT_EQ(found.ranges.size(), 1u);
  EXPECT_LE(found.ranges[0].low, best.values[0]);
  EXPECT_GE(found.ranges[0].high, best.values[0]);
  EXPECT_TRUE(found.ranges[0].isSeen);
  // The range is that of depths whose runs meet the target, no more.
  for (const std::size_t i : found.equallyGood) EXPECT_NEAR(*found.evaluations[i].targets[0].value, 70, 7);

  const auto text = calibratedCase(found);
  EXPECT_THAT(text, HasSubstr("estimated: "));
  const auto description = cases::parseCase(text, "calibrated");
  EXPECT_EQ(cases::numberInUnit(description, *cases::findParameter("defect.depth")), best.values[0]);

  // The same call takes every point from the folder: nothing is computed, and the outcome is the same.
  const auto again = calibrate(depthFor(folder, 70, 0.1), optionsFor(folder), monitor);
  EXPECT_TRUE(again.complete);
  EXPECT_EQ(again.evaluations.size(), found.evaluations.size());
  EXPECT_EQ(again.best, found.best);
  EXPECT_EQ(again.ranges[0].low, found.ranges[0].low);
  EXPECT_EQ(again.ranges[0].high, found.ranges[0].high);
}

// Two parts compute the points that depend on no other, each once; the search behind them visits the points of one
// process, and does not compute those again.
TEST(Calibrate, PartsShareThePointsThatFillTheLimits) {
  const TemporaryFolder together, alone;
  Monitor monitor;
  auto options = optionsFor(together);
  options.jobs = 1, options.threads = 2;
  std::set<Values> ofParts;
  std::size_t count = 0;
  for (const std::size_t part : {1, 2}) {
    options.part = studies::Partition{studies::Partition::Kind::slice, part, 2};
    const auto share = calibrate(depthFor(together, 70, 0.1), options, monitor);
    EXPECT_TRUE(share.complete);
    count += share.evaluations.size();
    for (const auto& row : share.evaluations) ofParts.insert(row.values);
  }
  EXPECT_EQ(ofParts.size(), count) << "no point twice";
  EXPECT_GE(count, 5u);

  options.part.reset();
  const auto whole = calibrate(depthFor(together, 70, 0.1), options, monitor);
  options.folder = alone.path();
  const auto single = calibrate(depthFor(alone, 70, 0.1), options, monitor);
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(readWholeFile(together / "calibration.csv", 1000000), readWholeFile(alone / "calibration.csv", 1000000));
  std::size_t global = 0;
  for (const auto& row : single.evaluations) global += row.stage == Stage::start || row.stage == Stage::global;
  EXPECT_EQ(global, count);
}

TEST(Calibrate, SaysWhatIsOutOfReach) {
  const TemporaryFolder folder;
  Monitor monitor;
  const auto found = calibrate(depthFor(folder, 900, 0.05), optionsFor(folder), monitor);
  ASSERT_EQ(found.outOfReach.size(), 1u);
  EXPECT_THAT(found.outOfReach[0], HasSubstr("'peak' asks for 855 to 945 m/s²; the nearest"));
}

TEST(Calibrate, CancelledItKeepsItsPointsAndResumes) {
  const TemporaryFolder folder;
  class StopsSoon : public Monitor {
   public:
    void report(const Progress& progress) override { points_ += progress.fraction > 0 ? 1 : 0; }
    bool cancelled() override { return points_ >= 3; }

   private:
    int points_ = 0;
  } stops;
  const auto part = calibrate(depthFor(folder, 70, 0.1), optionsFor(folder), stops);
  EXPECT_FALSE(part.complete);
  EXPECT_GE(part.evaluations.size(), 3u);
  EXPECT_LE(part.evaluations.size(), 5u);
  Monitor monitor;
  const auto whole = calibrate(depthFor(folder, 70, 0.1), optionsFor(folder), monitor);
  EXPECT_TRUE(whole.complete);
  for (std::size_t i = 0; i < part.evaluations.size(); ++i)
    EXPECT_EQ(whole.evaluations[i].values, part.evaluations[i].values);
}

TEST(Calibrate, LimitsInWhichNothingCanBeRunAreSaid) {
  const TemporaryFolder folder;
  auto definition = depthFor(folder, 70, 0.1);
  definition.inputs = freeInputsFromText({"wheelset.journal_radius=140:150"});  // above the shoulder and the seat
  Monitor monitor;
  try {
    calibrate(definition, optionsFor(folder), monitor);
    FAIL() << "taken";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no point can be run"));
  }
}

}  // namespace
}  // namespace squat::calibration
