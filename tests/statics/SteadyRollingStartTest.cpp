// Velocities of a steady-rolling start: those of a wheel and its deflections that travel at the vehicle's speed.
#include "statics/SteadyRollingStart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "case/Resolve.h"
#include "model/WheelMotion.h"

namespace squat::statics {
namespace {

// A point of the rail moves as the equilibrium under it changes while the wheel rolls on: v (u(x + h) - u(x - h)) / 2h,
// from two equilibria with the wheel
// turned as it rolls, where the start solves one linear system. Points between the patch and 40 mm are compared, where
// the head sinks ahead of the wheel and rises behind it.
TEST(SteadyRollingStart, TheRailMovesFromOneEquilibriumToTheNext) {
  const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  ThreadTeam team(2);
  Monitor quiet;
  const auto& kernels = elasticity::kernelsFor("");
  const auto start = prepareSteadyRollingStart(model, kernels, team, quiet);
  constexpr double step = 1e-4;  // [m] hardly a point of the patch comes or goes in between
  const double turn = step / model.surfaces.radius;
  const auto ahead = findEquilibrium(model, kernels, team, model.startX + step, turn, {}, quiet);
  const auto behind = findEquilibrium(model, kernels, team, model.startX - step, -turn, {}, quiet);
  const auto& rail = model.blocks[model.rail];
  int middle = 0;
  for (const int node : model.surfaces.railLine)
    if (std::abs(rail.section.nodes[node][0]) < 1e-9) middle = node;
  int compared = 0;
  for (int s = 1; s < rail.intervals; ++s) {
    const double x = rail.positions[s] - model.startX;
    if (std::abs(x) < 0.012 || std::abs(x) > 0.04) continue;
    const auto index = rail.index(middle, 2, s);
    const double expected =
        model.scenario.motion.speed * (ahead.displacement[index] - behind.displacement[index]) / (2 * step);
    EXPECT_EQ(start.velocity[index]<0, x> 0) << x;
    // Points of the patch close and open within the step, which the rate does not know.
    EXPECT_NEAR(start.velocity[index], expected, 0.05 * std::abs(expected)) << x;
    ++compared;
  }
  EXPECT_GE(compared, 6);
  EXPECT_NEAR(model::meanRotation(model, start.velocity.data()), 0, 1e-12);
  EXPECT_FALSE(start.equilibrium.cancelled);
}

double wheelHeight(const model::Model& model, const AlignedVector& u) {
  model::TurnedStations turned;
  model::turnStations(model.blocks[model.body], 0, turned);
  return model::ringMean(model, model.centre, turned, u.data()).z;
}

// The wheel rises and falls with the deflected rail: its velocity is that between equilibria 60 mm apart, further than
// the ripple of single elements reaches. That ripple, 1 to 2 um, is 5e-5 of the 60 mm; it made slopes of 8e-4
// and 1.3e-3 where these wheels start.
TEST(SteadyRollingStart, TheWheelFollowsTheRailAndNotItsElements) {
  for (const auto& settings : {cases::PresetValues{}, cases::PresetValues{{"wheelset.radius", "0.315"},
                                                                          {"wheelset.rim_inner_radius", "247"}}}) {
    const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", settings}));
    ThreadTeam team(2);
    Monitor quiet;
    const auto& kernels = elasticity::kernelsFor("");
    const auto start = prepareSteadyRollingStart(model, kernels, team, quiet);
    constexpr double reach = 0.03;  // [m]
    const auto ahead = findEquilibrium(model, kernels, team, model.startX + reach, 0, {}, quiet);
    const auto behind = findEquilibrium(model, kernels, team, model.startX - reach, 0, {}, quiet);
    const double slope =
        (wheelHeight(model, ahead.displacement) - wheelHeight(model, behind.displacement)) / (2 * reach);
    EXPECT_NEAR(wheelHeight(model, start.velocity) / model.scenario.motion.speed, slope, 1e-4);
  }
}

}  // namespace
}  // namespace squat::statics
