// Growth on the tiny mesh, with one freely rolling wheelset for the traffic.
#include "growth/Grow.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "TemporaryFolder.h"
#include "core/Errors.h"
#include "growth/PassingWheelset.h"
#include "growth/RollingTraffic.h"
#include "growth/SmallRail.h"

namespace squat::growth {
namespace {

using tests::growingDefect;

constexpr double megatonne = 1e9;

GrowthOptions plain(double tonnage) {
  GrowthOptions options;
  options.tonnage = tonnage * megatonne, options.threads = 1;
  return options;
}

double highestOf(const Field& shape) {
  double highest = 0;
  for (const double height : shape) highest = std::max(highest, std::abs(height));
  return highest;
}

// Cancels as soon as the growth has so many stages.
class Watcher : public Monitor {
 public:
  bool cancelled() override { return stop; }
  bool stop = false;
};

// Archard: volume = k / (mu H) times the work of friction. Both are sums over the same points and steps: round-off.
TEST(Growth, WearIsTheCoefficientTimesTheWork) {
  Monitor silent;
  PassingWheelset wheelset(
      growingCase(growingDefect(
          {{"motion.traction_coefficient", "0.1"}, {"growth.wear_coefficient", "0.0004"}, {"growth.hardness", "3"}})),
      1, "", silent);
  ASSERT_TRUE(wheelset.release());
  const auto& rail = wheelset.description().rail;
  const auto grid = surfaceGrid(wheelset.model(), rail.plasticFrom, rail.plasticTo);
  const Field flat(grid.size(), 0.0);
  const auto passage = wheelset.roll(grid, {{}, {}, wheelset.model(), flat, flat});
  ASSERT_TRUE(passage);
  double volume = 0;
  for (std::size_t i = 0; i < passage->worn.size(); ++i) volume += passage->worn[i] * wheelset.model().surfaces.area[i];
  ASSERT_GT(passage->frictionWork, 0.1);
  EXPECT_NEAR(volume, 0.0004 / (0.3 * 3e9) * passage->frictionWork, 1e-12 * volume);
  // Again, from the same released state: the same bits.
  const auto again = wheelset.roll(grid, {{}, {}, wheelset.model(), flat, flat});
  EXPECT_EQ(again->worn, passage->worn);
  EXPECT_EQ(again->acceleration, passage->acceleration);
}

// Wear alone: what a wheel does to a smooth rail it does everywhere alike, but for what the sleepers and the start of
// rolling leave in its load and speed, which is most on this mesh: some micrometres in 20 Mt. The bound is the one
// asked for.
TEST(Growth, SmoothRailStaysSmooth) {
  Monitor silent;
  const auto growth = grow(growingDefect({{"defect.shape", "none"}}), plain(2), silent);
  ASSERT_TRUE(growth.complete);
  EXPECT_LT(highestOf(growth.shapes.back()), 1e-6);
  EXPECT_GT(growth.stages.back().wearAround, 1e-7);
}

// A rail that yields sinks under the first wheels, and it does so evenly: 20 wheelsets. Loads vary by some percent on
// this mesh, and flow by more, so that a fifth of what it sinks counts as even.
TEST(Growth, AYieldingSmoothRailSinksEvenly) {
  Monitor silent;
  const auto growth =
      grow(growingDefect({{"defect.shape", "none"}, {"rail.preset", "R350HT"}}), plain(0.00036), silent);
  ASSERT_TRUE(growth.complete);
  const double sunk = growth.stages.back().flowAround;
  EXPECT_GT(sunk, 0.5e-6);
  EXPECT_LT(highestOf(growth.shapes.back()), 0.2 * sunk);
}

// Stopped between two blocks and resumed: the same bits as without.
TEST(Growth, ResumedGrowthHasTheSameBits) {
  const tests::TemporaryFolder folder;
  const auto description = growingDefect({{"rail.preset", "R260"}});
  auto options = plain(0.0002);
  Watcher watcher;
  const auto whole = grow(description, options, watcher);
  ASSERT_TRUE(whole.complete);
  ASSERT_GT(whole.stages.size(), 2u);

  options.checkpoint = folder / "growth.checkpoint";
  options.resume = true;
  int stages = 0;
  std::vector<Growth> reported;
  options.finishedStage = [&](const Stage&) { watcher.stop = ++stages == 2; };
  options.soFar = [&](const Growth& soFar) { reported.push_back(soFar); };
  const auto stopped = grow(description, options, watcher);
  EXPECT_FALSE(stopped.complete);
  ASSERT_EQ(reported.size(), 2u);  // one after each stage
  EXPECT_EQ(reported[0].stages.size(), 1u);
  EXPECT_EQ(reported[1].stages, stopped.stages);
  EXPECT_EQ(reported[1].shapes, stopped.shapes);
  EXPECT_EQ(reported[1].x, stopped.x);
  EXPECT_FALSE(reported[1].complete);
  reported.clear();
  watcher.stop = false, options.finishedStage = {};
  const auto resumed = grow(description, options, watcher);
  ASSERT_TRUE(resumed.complete);
  EXPECT_TRUE(resumed.resumed);
  EXPECT_EQ(resumed.stages, whole.stages);
  // From the checkpoint on, the last one with all that has come.
  ASSERT_FALSE(reported.empty());
  EXPECT_LT(reported.front().stages.size(), whole.stages.size());
  EXPECT_EQ(reported.back().stages, whole.stages);
  EXPECT_EQ(resumed.shapes, whole.shapes);
  EXPECT_EQ(resumed.wear, whole.wear);

  // What is asked for must lie ahead of the checkpoint.
  auto past = options;
  past.tonnage = plain(0.0001).tonnage;
  EXPECT_THROW(grow(description, past, watcher), CaseError);
  past.tonnage = plain(0.001).tonnage, past.grindings = {{1e-4, plain(0.0001).tonnage}};
  EXPECT_THROW(grow(description, past, watcher), CaseError);

  const auto other = growingDefect({{"rail.preset", "R260"}, {"contact.friction", "0.25"}});
  EXPECT_THROW(grow(other, options, watcher), CaseError);
}

// Ground by 0.05 mm after half of the traffic: a dip of 0.15 mm keeps what lies deeper, and nothing else is left of it.
TEST(Growth, GrindingTakesOffWhatStandsAbove) {
  Monitor silent;
  auto options = plain(1);
  options.grindings = {{0.05e-3, 0.5 * megatonne}};
  const auto growth = grow(growingDefect(), options, silent);
  ASSERT_TRUE(growth.complete);
  const auto ground = std::find_if(growth.stages.begin(), growth.stages.end(), [](const Stage& s) { return s.ground; });
  ASSERT_NE(ground, growth.stages.end());
  EXPECT_NEAR(ground->tonnage, 0.5 * megatonne, 1e-5 * megatonne);
  EXPECT_NEAR(ground->depth, (ground - 1)->depth - 0.05e-3, 1e-9);
  const auto& shape = growth.shapes[static_cast<std::size_t>(ground - growth.stages.begin())];
  EXPECT_LE(*std::max_element(shape.begin(), shape.end()), 1e-15);  // nothing stands above the new surface
  EXPECT_LT(ground->peakAcceleration, (ground - 1)->peakAcceleration);
}

TEST(Growth, EndsAtADepth) {
  Monitor silent;
  auto options = plain(1);
  options.untilDepth = 0.1e-3;  // it is that deep already
  const auto growth = grow(growingDefect(), options, silent);
  EXPECT_TRUE(growth.complete);
  EXPECT_EQ(growth.stages.size(), 1u);
}

TEST(Growth, SenselessCallsAreRefused) {
  Monitor silent;
  EXPECT_THROW(grow(growingDefect(), plain(0), silent), CaseError);
  auto options = plain(1);
  options.grindings = {{0.1e-3, 2 * megatonne}};  // behind the end
  EXPECT_THROW(grow(growingDefect(), options, silent), CaseError);
  options.grindings = {{-0.1e-3, 0.5 * megatonne}};
  EXPECT_THROW(grow(growingDefect(), options, silent), CaseError);
}

TEST(Growth, TheLastCleanTonnageCountsFromTheLastGrinding) {
  Growth growth;
  const auto stage = [&](double tonnage, double strained, bool ground) {
    Stage one;
    one.tonnage = tonnage * megatonne, one.strainedDepth = strained, one.ground = ground;
    growth.stages.push_back(one);
  };
  stage(0, 0, false), stage(2, 0.1e-3, false), stage(4, 0.3e-3, false);
  EXPECT_DOUBLE_EQ(*lastCleanTonnage(growth, 0.2e-3), 2 * megatonne);
  stage(4, 0, true), stage(7, 0.15e-3, false), stage(9, 0.25e-3, false);
  EXPECT_DOUBLE_EQ(*lastCleanTonnage(growth, 0.2e-3), 3 * megatonne);
  stage(9, 0.25e-3, true);
  EXPECT_FALSE(lastCleanTonnage(growth, 0.2e-3));
}

// Lengths of the mesh are in mm: 0.25 for a quarter of a metre leaves no room for the defect.
TEST(Growth, AZoneThatDoesNotHoldTheDefectIsRefused) {
  try {
    growingCase(growingDefect({{"mesh.zone_behind", "0.25"}}));
    FAIL() << "no error";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("mesh.zone_behind is 0.25 mm, must be at least "));
  }
}

}  // namespace
}  // namespace squat::growth
