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

// In steady rolling a rail point sees the deflection pass: du/dt = -v du/dx where the track is the same all along. Just
// under the wheel du_z/dx = 0 for the head's sinking; ahead of the wheel the rail goes down, behind it comes up.
TEST(SteadyRollingStart, RailSinksAheadOfTheWheelAndRisesBehind) {
  const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  ThreadTeam team(1);
  Monitor quiet;
  const auto start = prepareSteadyRollingStart(model, elasticity::kernelsFor(""), team, quiet);
  const auto& rail = model.blocks[model.rail];
  const auto& u = start.equilibrium.displacement;
  const double speed = model.scenario.motion.speed;
  int middle = 0;
  for (const int node : model.surfaces.railLine)
    if (std::abs(rail.section.nodes[node][0]) < 1e-9) middle = node;
  int compared = 0;
  for (int s = 1; s < rail.intervals; ++s) {
    const double x = rail.positions[s] - model.startX;
    // Outside the patch, where the deflection varies over several stations.
    if (std::abs(x) < 0.012 || std::abs(x) > 0.04) continue;
    const double slope = (u[rail.index(middle, 2, s + 1)] - u[rail.index(middle, 2, s - 1)]) /
                         (rail.positions[s + 1] - rail.positions[s - 1]);
    const double velocity = start.velocity[rail.index(middle, 2, s)];
    EXPECT_EQ(velocity<0, x> 0) << x;
    // Half: sleepers, and stations that grow, make the deflection differ from a travelling one.
    EXPECT_NEAR(velocity, -speed * slope, 0.5 * std::abs(speed * slope)) << x;
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
