// Files of a growth, and the state that a checkpoint holds.
#include "growth/GrowthFiles.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "TemporaryFolder.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "growth/GrowthState.h"
#include "growth/SmallRail.h"
#include "growth/SurfaceSeries.h"
#include "results/Hdf5.h"

namespace squat::growth {
namespace {

using ::testing::HasSubstr;

// Three stations, two lines, two stages.
Growth smallGrowth() {
  Growth growth;
  growth.description = growingCase(tests::growingDefect());
  growth.bandHalfWidth = tests::growingDefect().mesh.bandHalfWidth;
  growth.traffic = {{0.001, 1.1, 0.9, 0.02}};
  growth.speeds = {27}, growth.wheelLoads = {95000};
  growth.x = {-0.01, 0, 0.01}, growth.y = {-0.005, 0.005};
  growth.stages.resize(2);
  growth.stages[1].tonnage = 2.5e9, growth.stages[1].depth = 0.2e-3, growth.stages[1].waveLength = 0.031;
  growth.shapes = {{0, 0, -1e-4, -1e-4, 0, 0}, {0, 0, -2e-4, -1.5e-4, 0, 1e-6}};
  growth.wear = Field(6, -1e-6), growth.flow = Field(6, -2e-6);
  growth.complete = true;
  return growth;
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(GrowthFiles, TableAndSurfaces) {
  const tests::TemporaryFolder folder;
  const auto written = writeGrowthFiles(smallGrowth(), folder.path(), "dip");
  ASSERT_EQ(written.size(), 3u);
  const auto table = contentOf(written[0]);
  EXPECT_THAT(table, HasSubstr("tonnage [Mt],wheelsets,depth [mm]"));
  EXPECT_THAT(table, HasSubstr("\n2.5,0,0.2,"));
  const auto tree = results::readHdf5(written[1]);
  EXPECT_EQ(results::textAttribute(tree.attributes, "schema"), "squat-growth");
  ASSERT_TRUE(tree.find("/surface/height"));
  EXPECT_THAT(tree.find("/surface/height")->shape, ::testing::ElementsAre(2, 3, 2));
  EXPECT_FLOAT_EQ(results::valuesOf<float>(tree, "/surface/height", "")[6 + 2], -2e-4F);
  EXPECT_DOUBLE_EQ(results::valuesOf<double>(tree, "/stages/wave_length", "")[1], 0.031);
}

TEST(GrowthFiles, SurfacesAreReadBack) {
  const tests::TemporaryFolder folder;
  const auto growth = smallGrowth();
  const auto written = writeGrowthFiles(growth, folder.path(), "dip");
  const auto series = readSurfaceSeries(written[1]);
  EXPECT_EQ(series.x, growth.x);
  EXPECT_EQ(series.y, growth.y);
  ASSERT_EQ(series.height.size(), 2u);
  EXPECT_FLOAT_EQ(series.height[1][3], -1.5e-4F);
  auto tree = growthTree(growth);
  tree.find("/surface/height")->values = std::vector<float>{1};
  EXPECT_THROW(surfaceSeriesFrom(tree, "x.h5"), FileError);
  EXPECT_THROW(surfaceSeriesFrom({}, "x.h5"), FileError);
}

// The grown case has the surface of the last stage: its deepest point is where that was, its lines are those.
TEST(GrowthFiles, TheGrownCaseHasTheLastSurface) {
  const tests::TemporaryFolder folder;
  const auto written = writeGrowthFiles(smallGrowth(), folder.path(), "dip");
  const auto scenario = cases::resolve(cases::readCase(written[2]));
  EXPECT_NEAR(scenario.defectSurface.depth(), 2e-4, 1e-12);
  EXPECT_NEAR(scenario.defectSurface.height(0, -0.005), -2e-4, 1e-12);
  EXPECT_NEAR(scenario.defectSurface.height(0, 0.005), -1.5e-4, 1e-12);
  EXPECT_EQ(scenario.rail.plasticTo, 0);
}

// A rail that has grown can grow on: its defect reaches over the whole stretch, and the mesh over more.
TEST(GrowthFiles, AGrownCaseGrowsOn) {
  const tests::TemporaryFolder folder;
  const auto written = writeGrowthFiles(smallGrowth(), folder.path(), "dip");
  const auto grown = cases::readCase(written[2]), again = growingCase(grown);
  EXPECT_EQ(grown.mesh.bandHalfWidth, tests::growingDefect().mesh.bandHalfWidth);
  EXPECT_LE(again.mesh.zoneBehind, 0.01 + 0.15);
  EXPECT_GE(again.mesh.zoneBefore, 0.01 + fadingLength + endEffect);
}

TEST(GrowthFiles, TheSummarySaysWhatHasChanged) {
  auto growth = smallGrowth();
  growth.stages[0].depth = 0.15e-3;
  const auto summary = growthSummary(growth, {});
  EXPECT_THAT(summary, HasSubstr("95.0 kN"));
  EXPECT_THAT(summary, HasSubstr("0.050 mm deeper in 2.50 Mt"));
}

TEST(GrowthState, ComesBackFromItsTree) {
  GrowthState state;
  state.wear = {1, 2}, state.flow = {3, 4}, state.cut = {5, 6};
  state.layer.values = {7, 8}, state.layerBefore.values = {9, 10}, state.displacement = {11};
  state.rates = {{0.5, 0.25}, {0.125, 0}};
  state.tonnage = 12, state.passages = 13, state.block = 14, state.grindings = 2;
  Stage stage;
  stage.tonnage = 16, stage.smallestForce = 17, stage.peakAcceleration = 18, stage.ground = true;
  state.stages = {Stage{}, stage};
  state.shapes = {{19, 20}, {21, 22}};
  const auto back = stateFrom(treeOf(state), "a file");
  EXPECT_EQ(back.wear, state.wear);
  EXPECT_EQ(back.flow, state.flow);
  EXPECT_EQ(back.cut, state.cut);
  EXPECT_EQ(back.layer.values, state.layer.values);
  EXPECT_EQ(back.layerBefore.values, state.layerBefore.values);
  EXPECT_EQ(back.displacement, state.displacement);
  EXPECT_EQ(back.rates.flow, state.rates.flow);
  EXPECT_EQ(back.stages, state.stages);
  EXPECT_EQ(back.shapes, state.shapes);
  EXPECT_EQ(back.block, 14);
  EXPECT_EQ(back.grindings, 2u);
  auto tree = treeOf(state);
  tree.find("/growth/shapes")->values = std::vector<double>{1};
  EXPECT_THROW(stateFrom(tree, "a file"), FileError);
}

}  // namespace
}  // namespace squat::growth
