// A rail that is not smooth: what its keys do to the contact points of the rail, and to a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "TemporaryFolder.h"
#include "elasticity/SweptSamples.h"
#include "geometry/RailSection.h"
#include "keys/Keys.h"
#include "simulation/RunCase.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::scenarioWith;
using tests::Values;

double levelOf(const scenario::IrregularSurface& surface) {
  double square = 0;
  for (const auto& h : surface.harmonics()) square += 0.5 * h.amplitude * h.amplitude;
  return 10 * std::log10(square / 1e-12);
}

// One third octave alone has the level that is given.
TEST(IrregularityKeys, SetLevelsAndWavelengths) {
  const auto only = [](Values values, const char* wavelength) {
    values.push_back({"rail.irregularity_shortest", wavelength});
    values.push_back({"rail.irregularity_longest", wavelength});
    return levelOf(scenarioWith(values).irregularity);
  };
  const Values iso{{"rail.irregularity", "iso-3095"}};
  EXPECT_NEAR(only(iso, "40"), -3.2, 1e-9);
  EXPECT_NEAR(only(iso, "100"), 4.9, 1e-9);
  const Values own{{"rail.irregularity", "spectrum"}, {"rail.irregularity_levels", "20: 3, 80: 9"}};
  EXPECT_NEAR(only(own, "80"), 9, 1e-9);
  EXPECT_NEAR(only({{"rail.irregularity", "iso-3095"}, {"rail.irregularity_offset", "6"}}, "40"), 2.8, 1e-9);
  const auto one = scenarioWith(iso).irregularity,
             other = scenarioWith({{"rail.irregularity", "iso-3095"}, {"rail.irregularity_seed", "2"}}).irregularity;
  EXPECT_NE(one.height(0.05), other.height(0.05));
  EXPECT_NEAR(levelOf(one), levelOf(other), 1e-9);
}

TEST(IrregularityKeys, ReadFiles) {
  const tests::TemporaryFolder folder;
  const auto writtenFile = [&](const char* name, const char* text) {
    const auto path = folder / name;
    std::ofstream(path) << text;
    return path;
  };
  const auto spectrum = writtenFile("levels.csv", "wavelength [cm]; level [dB re 1 um]\n2; 3\n4; 5\n");
  const auto rough = scenarioWith({{"rail.irregularity", "spectrum"},
                                   {"rail.irregularity_file", spectrum},
                                   {"rail.irregularity_shortest", "40"},
                                   {"rail.irregularity_longest", "40"}});
  EXPECT_NEAR(levelOf(rough.irregularity), 5, 1e-9);
  const auto heights = writtenFile("heights.csv", "position [m], height [um]\n-1, 0\n0, 0\n0.05, 30\n1, 0\n");
  const auto given = scenarioWith({{"rail.irregularity", "heights"}, {"rail.irregularity_file", heights}}).irregularity;
  EXPECT_NEAR(given.height(0.05), 30e-6, 1e-15);
}

// The points of the contact stand as much higher than those of a smooth rail as the irregularity says, on all columns.
TEST(IrregularityKeys, RaiseTheContactPoints) {
  const Values values{{"rail.irregularity", "heights"},
                      {"rail.irregularity_points", "[[900, 0], [1000, 0.02], [1050, -0.01], [1300, 0]]"},
                      {"rail.irregularity_position", "1"}};
  const auto rough = modelWith(values), smooth = modelWith({});
  const auto& surface = rough.scenario.irregularity;
  EXPECT_NEAR(surface.height(0), 20e-6, 1e-15);
  ASSERT_EQ(rough.surfaces.points(), smooth.surfaces.points());
  double largest = 0;
  for (std::size_t i = 0; i < rough.surfaces.points(); ++i) {
    const double expected = surface.height(rough.surfaces.pointX[i]);
    EXPECT_NEAR(rough.surfaces.height[i] - smooth.surfaces.height[i], expected, 1e-15);
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_GT(largest, 10e-6);
  EXPECT_GT(rough.surfaces.reach, smooth.surfaces.reach - 1e-15);
}

// A wheel starts on a rough rail as on a smooth one, and what the rail's heights make of its force stays below the
// load: 10 dB above the limits of ISO 3095 no wheel leaves the rail.
TEST(IrregularityKeys, ARunStartsQuietlyAndFollowsTheRail) {
  const auto rolled = [](Values values) {
    for (const auto& [key, text] : Values{{"motion.run_up", "0.1"}, {"motion.beyond", "0.05"}, {"motion.torque", "0"}})
      values.push_back({key, text});
    simulation::RunOptions options;
    options.threads = 1;
    options.wheelsetModes = options.snapshots = false;
    Monitor silent;
    return simulation::runCase(cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", values}), options, silent);
  };
  const auto smooth = rolled({});
  const auto rough = rolled(
      {{"rail.irregularity", "iso-3095"}, {"rail.irregularity_shortest", "40"}, {"rail.irregularity_offset", "10"}});
  EXPECT_FALSE(smooth.signal("irregularity"));
  const auto& heights = *rough.signal("irregularity");
  const auto &before = *smooth.signal("contact_force"), &after = *rough.signal("contact_force");
  double moved = 0, disturbed = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    // Patch, 7 mm, and delay of the filters keep what begins at 10 mm from the first 2 mm.
    if (rough.position[i] < -0.098) {
      EXPECT_NEAR(after[i], before[i], 2) << i;  // equilibrium is solved to some 1e-6 of the load
    }
    moved = std::max(moved, std::abs(heights[i]));
    disturbed = std::max(disturbed, std::abs(after[i] - before[i]));
  }
  EXPECT_GT(moved, 3e-6);  // rms 16 um up to 0.4 m of wavelength; over 0.1 m some of it
  EXPECT_GT(disturbed, 500);
  EXPECT_LT(disturbed, 40e3);
}

}  // namespace
}  // namespace squat
