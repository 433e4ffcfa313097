// The real wheel on the real rail at rest, mesh `draft`: patch and peak pressure by moments, load.
// Theory: Hertz for R = 0.46 m on R300, E 210 GPa, nu 0.3; half axes and p0 from CONTACT 25.2 (60 x 60 elements) for
// 87.8 kN: a = 6.86 mm along, b = 5.16 mm across, 1185 MPa, all growing with the cube root of the load.
// Tolerance 12 %: quads of 2.6 mm, five along the patch; 1e-6 for the load, what the equilibrium is solved to.
#include <gtest/gtest.h>

#include <cmath>

#include "case/CaseFile.h"
#include "statics/Equilibrium.h"

namespace squat::statics {
namespace {

TEST(WheelOnRailHertz, Draft) {
  const auto model = model::buildModel(cases::loadCase("smooth-rail", {"draft", {}}));
  ThreadTeam team(threadCount(0));
  Monitor quiet;
  const auto e = findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
  const auto& d = model.description;
  const double weight = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
  EXPECT_NEAR(e.contactForce, weight, 1e-6 * weight);
  const double scale = std::cbrt(weight / 87.8e3);
  EXPECT_NEAR(e.halfAxisRolling, 6.86e-3 * scale, 0.12 * 6.86e-3);
  EXPECT_NEAR(e.halfAxisLateral, 5.16e-3 * scale, 0.12 * 5.16e-3);
  EXPECT_NEAR(e.peakPressure, 1185e6 * scale, 0.12 * 1185e6);
}

}  // namespace
}  // namespace squat::statics
