// Velocities of a steady-rolling start: those of a wheel and its deflections that travel at the vehicle's speed.
#include "statics/SteadyRollingStart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
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

}  // namespace
}  // namespace squat::statics
