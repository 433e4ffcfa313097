// Static deflection of the rail under the wheel.
// Theory: Timoshenko beam on pads, bending sleepers and ballast (TrackBeam.h), the rail's section integrals those of
// the mesh. Compared is the mean vertical displacement of the rail's section under the wheel, weight of the track
// included. Tolerance 3 %: the web and foot of the solid rail give way under wheel and pads, which no beam does;
// sections of the coarsest mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "statics/Equilibrium.h"
#include "verification/Seen.h"
#include "verification/TrackBeam.h"

namespace squat::verification {
namespace {

// Mean over a section by mass, linear between stations.
double sectionMean(const model::Model& model, const AlignedVector& u, double x) {
  const auto& rail = model.blocks[model.rail];
  const int s =
      static_cast<int>(std::upper_bound(rail.positions.begin(), rail.positions.end(), x) - rail.positions.begin()) - 1;
  const double t = (x - rail.positions[s]) / (rail.positions[s + 1] - rail.positions[s]);
  double mean[2] = {0, 0};
  for (const int side : {0, 1}) {
    double mass = 0;
    for (int n = 0; n < rail.nodes; ++n) {
      const double m = model.mass[model.rail][n * rail.stride + s + side];
      mass += m, mean[side] += m * u[rail.index(n, 2, s + side)];
    }
    mean[side] /= mass;
  }
  return (1 - t) * mean[0] + t * mean[1];
}

TEST(RailDeflection, UnderTheWheelIsThatOfABeam) {
  const auto scenario =
      cases::loadScenario(tests::fixtureCase("smooth-rail"),
                          {"tiny", {{"track.length", "9"}, {"mesh.far_size", "100"}, {"mesh.section_size", "16"}}});
  const auto model = model::buildModel(scenario);
  ThreadTeam team(1);
  Monitor quiet;
  const auto e = statics::findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
  const auto& rail = model.blocks[model.rail];
  const TrackBeam beam(scenario, beamSection(rail.section), rail.positions.front(), model.sleeperPositions);
  for (const double away : {0.0, 0.3, 0.6}) {
    const double x = model.startX + away;
    const double expected = beam.deflection(x, model.startX, e.contactForce, true);
    const double found = sectionMean(model, e.displacement, x);
    EXPECT_NEAR(found, expected, 0.03 * std::abs(expected)) << away << " m from the wheel";
    seenDeviation("deflection", found, expected);
  }
}

}  // namespace
}  // namespace squat::verification
