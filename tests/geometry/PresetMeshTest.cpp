// Meshes of all presets as the model builds them: quality of the sections, stations, and what the presets promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "geometry/RailSection.h"
#include "model/BuildBlocks.h"

namespace squat::model {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

class PresetMesh : public testing::TestWithParam<const char*> {
 protected:
  static Model blocksOf(const char* preset) {
    Model model;
    model.scenario = cases::loadScenario(tests::fixtureCase("light-defect"), {preset, {}});
    addBlocks(model);
    return model;
  }
};

TEST_P(PresetMesh, SectionsAreWellShaped) {
  const Model model = blocksOf(GetParam());
  for (const auto& block : model.blocks)
    for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q) {
      const auto& p = block.section.nodes[block.section.quads[q][0]];
      // Below 0.3 a corner is under 18 degrees: such quads lose accuracy and set the time step.
      ASSERT_GT(geometry::scaledJacobian(block.section, q), 0.3) << block.name << " at " << p[0] << ", " << p[1];
    }
}

TEST_P(PresetMesh, The60E1IsWellShapedToo) {
  const auto mesh =
      cases::loadScenario(tests::fixtureCase("light-defect"), {GetParam(), {{"rail.section", "60E1"}}}).mesh;
  for (const bool coarse : {false, true}) {
    const auto section =
        geometry::railSectionMesh(geometry::RailSection::rail60E1,
                                  {mesh.contactSize, mesh.bandHalfWidth, mesh.sectionSize, mesh.sectionGrowth, coarse});
    for (int q = 0; q < static_cast<int>(section.quads.size()); ++q)
      ASSERT_GT(geometry::scaledJacobian(section, q), 0.3) << q;
  }
}

TEST_P(PresetMesh, StationsFillWholeVectorsAndGrowSlowly) {
  const Model model = blocksOf(GetParam());
  for (const auto& block : model.blocks) {
    const auto& runs = block.stations.runs;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      EXPECT_EQ(runs[r].count % 8, 0) << block.name;
      EXPECT_GT(runs[r].length, 0) << block.name;
      if (r == 0 && !block.closed) continue;
      const double ratio = runs[r].length / runs[r == 0 ? runs.size() - 1 : r - 1].length;
      EXPECT_LE(std::max(ratio, 1 / ratio), 2.0 * (1 + 1e-9)) << block.name << ", run " << r;
    }
  }
}

TEST_P(PresetMesh, RailAndWheelAreWhole) {
  const Model model = blocksOf(GetParam());
  const auto& rail = model.blocks[model.rail];
  EXPECT_NEAR(rail.positions.back() - rail.positions.front(), model.scenario.track.length, 1e-9);
  for (const int b : {model.rim, model.body}) {
    const auto& ring = model.blocks[b];
    EXPECT_TRUE(ring.closed);
    EXPECT_NEAR(ring.positions.back() - ring.positions.front(), 2 * std::acos(-1.0), 1e-12);
  }
}

// Stations of wheel and rail stand opposite each other where they roll on each other.
TEST_P(PresetMesh, RimRollsOnTheRailsStations) {
  Model model;
  model.scenario = cases::loadScenario(tests::fixtureCase("light-defect"), {GetParam(), {}});
  const auto stretch = addBlocks(model);
  const auto &rail = model.blocks[model.rail], &rim = model.blocks[model.rim];
  const auto first = std::lower_bound(rail.positions.begin(), rail.positions.end(), stretch.from - 1e-9);
  int count = 0;
  for (const auto& run : stretch.rolled) count += run.count;
  for (int i = 0; i <= count; ++i)
    ASSERT_NEAR(model.startX + rim.positions[i] * model.scenario.wheelset.radius, *(first + i), 1e-9);
  EXPECT_LE(stretch.from, -model.scenario.motion.runUp - 0.010);  // the patch's half length and more
  EXPECT_GE(stretch.to, model.scenario.motion.beyond + 0.010);
}

TEST_P(PresetMesh, HasTheElementsThatThePresetPromises) {
  const std::string preset = GetParam();
  const auto elements = blocksOf(GetParam()).elements();
  if (preset == "tiny") {
    EXPECT_LE(elements, 15000u);
  }
  if (preset == "draft") {
    EXPECT_LE(elements, 80000u);
  }
  if (preset == "paper") {
    EXPECT_NEAR(static_cast<double>(elements), 344816, 0.1 * 344816);
  }
  EXPECT_GT(elements, 5000u);
}

INSTANTIATE_TEST_SUITE_P(AllPresets, PresetMesh, testing::Values("tiny", "draft", "standard", "paper"),
                         [](const auto& preset) { return std::string(preset.param); });

// The finest stations, which set the time step, share their inertia in whole groups of 16. (Not on tiny: no elements to
// spare.)
TEST(FineStations, ComeInWholeGroups) {
  for (const char* preset : {"draft", "standard", "paper"}) {
    Model model;
    model.scenario = cases::loadScenario(tests::fixtureCase("light-defect"), {preset, {}});
    addBlocks(model);
    for (const int b : {model.rail, model.rim}) {
      const auto& block = model.blocks[b];
      double finest = 1;
      for (const auto& run : block.stations.runs) finest = std::min(finest, run.length);
      for (std::size_t r = 0; r < block.stations.runs.size(); ++r)
        if (block.stations.runs[r].length < 1.01 * finest) {
          EXPECT_EQ(block.runIntervals[r][0] % 16, 0) << preset << ", " << block.name << ", run " << r;
          EXPECT_EQ(block.stations.runs[r].count % 16, 0) << preset << ", " << block.name << ", run " << r;
        }
    }
  }
}

RollingStretch stretchOf(const Settings& settings) {
  Model model;
  model.scenario = cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", settings});
  return addBlocks(model);
}

// Long rolling elements that find no room between fine zone and far rail: the fine zone goes as far as the wheel.
TEST(RollingStretch, ReachesAsFarAsTheWheelRolls) {
  const auto stretch = stretchOf({{"mesh.contact_size", "10"},
                                  {"mesh.rolling_size", "19"},
                                  {"mesh.fine_before", "40"},
                                  {"motion.beyond", "0.08"}});
  EXPECT_GE(stretch.to, 0.08 + 0.010);
}

// Zones that push each other over the rail's end are refused, not laid beside it.
TEST(RollingStretch, ZonesWithoutRoomAreRefused) {
  EXPECT_THROW(stretchOf({{"track.sleeper_spacing", "0.4"},
                          {"track.length", "2"},
                          {"mesh.far_size", "200"},
                          {"motion.run_up", "0.68"},
                          {"motion.beyond", "0.68"},
                          {"mesh.fine_start", "500"}}),
               CaseError);
}

}  // namespace
}  // namespace squat::model
