// The real wheel on the real rail at rest: patch and peak pressure by moments, load.
// Theory: Hertz for R = 0.46 m on R300, E 210 GPa, nu 0.3; half axes and p0 from CONTACT 25.2 (60 x 60 elements) for
// 87.8 kN: a = 6.86 mm along, b = 5.16 mm across, 1185 MPa, approach 0.0955 mm; lengths and pressure grow with the cube
// root of the load.
// Tolerance 6 % on the mesh `paper` (quads of 1.3 mm, eleven along the patch), 12 % on `draft` (2.6 mm); 1e-6 for the
// load, what the equilibrium is solved to.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "model/ContactPenalty.h"
#include "statics/Equilibrium.h"
#include "verification/Seen.h"

namespace squat::statics {
namespace {

constexpr double force = 87.8e3, along = 6.86e-3, across = 5.16e-3, peak = 1185e6, approach = 0.0955e-3;

void expectHertz(const std::string& mesh, double tolerance, const std::string& track,
                 const std::string& section = "54E1") {
  const auto model = model::buildModel(cases::loadScenario(
      tests::fixtureCase("smooth-rail"), {mesh, {{"track.length", track}, {"rail.section", section}}}));
  ThreadTeam team(threadCount(0));
  Monitor quiet;
  const auto e = findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
  const auto& d = model.scenario;
  const double weight = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
  const double scale = std::cbrt(weight / force);
  std::printf("  %-8s  a %.3f mm (%+.1f %%)  b %.3f mm (%+.1f %%)  p0 %.0f MPa (%+.1f %%)\n", mesh.c_str(),
              1e3 * e.halfAxisRolling, 100 * (e.halfAxisRolling / (along * scale) - 1), 1e3 * e.halfAxisLateral,
              100 * (e.halfAxisLateral / (across * scale) - 1), 1e-6 * e.peakPressure,
              100 * (e.peakPressure / (peak * scale) - 1));
  EXPECT_NEAR(e.contactForce, weight, 1e-6 * weight);
  EXPECT_NEAR(e.halfAxisRolling, along * scale, tolerance * along);
  EXPECT_NEAR(e.halfAxisLateral, across * scale, tolerance * across);
  EXPECT_NEAR(e.peakPressure, peak * scale, tolerance * peak);
  verification::seenDeviation("semi-axes on " + mesh, e.halfAxisRolling, along * scale);
  verification::seenDeviation("semi-axes on " + mesh, e.halfAxisLateral, across * scale);
  verification::seenDeviation("peak pressure on " + mesh, e.peakPressure, peak * scale);
}

// The patch does not feel the length of the track, and three metres take seconds.
TEST(WheelOnRailHertz, Draft) { expectHertz("draft", 0.12, "3"); }

// R300 in the middle, as 54E1.
TEST(WheelOn60E1, DraftIsHertz) { expectHertz("draft", 0.12, "3", "60E1"); }

TEST(WheelOnRailHertz, Paper) { expectHertz("paper", 0.06, "10"); }

// What the penalty adds to the approach, p0 / 2 k, stays below 4 % of Hertz's on the mesh `paper`.
TEST(WheelOnRailHertz, PenaltyOfThePapersMeshIsHard) {
  const double added =
      peak / 2 / model::normalPenalty(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"paper", {}}));
  std::printf("  p0 / 2 k = %.2f um, %.2f %% of the approach\n", 1e6 * added, 100 * added / approach);
  EXPECT_LT(added, 0.04 * approach);
}

}  // namespace
}  // namespace squat::statics
