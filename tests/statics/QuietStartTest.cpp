// Velocities of a quiet start: those of a wheel and its deflections that travel at the vehicle's speed.
#include "statics/QuietStart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "model/WheelMotion.h"

namespace squat::statics {
namespace {

model::Model tiny() { return model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}})); }

// The rail goes down ahead of the wheel and comes up behind it, outside the patch, where the deflection is not the
// patch's own.
TEST(QuietStart, RailSinksAheadOfTheWheelAndRisesBehind) {
  const auto model = tiny();
  ThreadTeam team(1);
  Monitor quiet;
  const auto start = prepareQuietStart(model, elasticity::kernelsFor(""), team, quiet);
  const auto& rail = model.blocks[model.rail];
  int middle = 0;
  for (const int node : model.surfaces.railLine)
    if (std::abs(rail.section.nodes[node][0]) < 1e-9) middle = node;
  int compared = 0;
  for (int s = 1; s < rail.intervals; ++s) {
    const double x = rail.positions[s] - model.startX;
    if (std::abs(x) < 0.012 || std::abs(x) > 0.3) continue;
    EXPECT_EQ(start.velocity[rail.index(middle, 2, s)]<0, x> 0) << x;
    ++compared;
  }
  EXPECT_GE(compared, 12);
  EXPECT_NEAR(model::meanSpin(model, start.velocity.data()), 0, 1e-12);
  EXPECT_FALSE(start.equilibrium.cancelled);
}

// The velocities are v du/dx of the equilibrium with the wheel at x: here from two equilibria 0.2 mm apart, each found
// by itself. Tolerance 1 % of the largest velocity: equilibria are solved to 1e-7 of the load, 2e-9 m on 45 MN/m, 1e-5
// of speed over 0.2 mm where the largest is about 1e-3 of it; contact points that open or close on the way add as much.
TEST(QuietStart, VelocitiesAreHowTheEquilibriumChanges) {
  const auto model = tiny();
  ThreadTeam team(1);
  Monitor quiet;
  const auto kernels = elasticity::kernelsFor("");
  const auto start = prepareQuietStart(model, kernels, team, quiet);
  constexpr double h = 1e-4;
  const auto at = [&](double x) {
    EquilibriumOptions options;
    options.guess = &start.equilibrium.displacement;
    options.tolerance = 1e-9;
    return findEquilibrium(model, kernels, team, model.startX + x, x / model.surfaces.radius, options, quiet);
  };
  const auto behind = at(-h), ahead = at(h);
  double largest = 0, difference = 0;
  const auto compare = [&](const elasticity::SweptBlock& block) {
    for (int n = 0; n < block.nodes; ++n)
      for (int c = 0; c < 3; ++c)
        for (int s = 0; s < block.stationCount; ++s) {
          const auto i = block.index(n, c, s);
          const double expected =
              model.scenario.motion.speed * (ahead.displacement[i] - behind.displacement[i]) / (2 * h);
          largest = std::max(largest, std::abs(expected));
          difference = std::max(difference, std::abs(start.velocity[i] - expected));
        }
  };
  compare(model.blocks[model.rail]);
  for (int i = 0; i < model.sleepers; ++i) compare(model.blocks[model.firstSleeper + i]);
  std::printf("largest velocity %.4g m/s, largest difference %.4g m/s\n", largest, difference);
  EXPECT_LT(difference, 0.01 * largest);
  EXPECT_GT(largest, 0.01);
}

}  // namespace
}  // namespace squat::statics
