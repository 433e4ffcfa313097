// Static deflection of the rail under the wheel, and the beam model itself against published receptances.
// Theory: Timoshenko beam on pads, bending sleepers and ballast (TrackBeam.h), the rail's section integrals those of
// the mesh. Compared is the mean vertical displacement of the rail's section under the wheel, weight of the track
// included. Tolerance 3 %: the web and foot of the solid rail give way under wheel and pads, which no beam does;
// sections of the coarsest mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/CaseFile.h"
#include "statics/Equilibrium.h"
#include "verification/TrackBeam.h"

namespace squat::verification {
namespace {

BeamSection sectionOf(const elasticity::SweptBlock& rail) {
  const auto integrals = geometry::sectionIntegrals(rail.section);
  double base = 0;
  for (const auto& p : rail.section.nodes) base = std::min(base, p[1]);
  return {integrals.area, integrals.momentCC, integrals.centroidC - base, 0.40};
}

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
  const auto description = cases::loadCase(
      "smooth-rail", {"tiny", {{"track.length", "9"}, {"mesh.far_size", "100"}, {"mesh.section_size", "16"}}});
  const auto model = model::buildModel(description);
  ThreadTeam team(1);
  Monitor quiet;
  const auto e = statics::findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
  const auto& rail = model.blocks[model.rail];
  const TrackBeam beam(description, sectionOf(rail), rail.positions.front(), model.sleeperPositions);
  for (const double away : {0.0, 0.3, 0.6}) {
    const double x = model.startX + away;
    const double expected = beam.deflection(x, model.startX, e.contactForce, true);
    const double found = sectionMean(model, e.displacement, x);
    EXPECT_NEAR(found, expected, 0.03 * std::abs(expected)) << away << " m from the wheel";
  }
}

// The beam itself, with rigid sleepers on a long track, against the numbers of a Timoshenko model made apart from it
// (25 mm elements, kappa 0.40, 100 bays, point supports, half sleeper 122 kg rigid): 1.000e-8 m/N over a sleeper
// and 1.045e-8 midspan at rest; 1.295e-8 and 1.337e-8 at 50 Hz; pin-pin at 1018 Hz. Pads of 20 mm stand for point
// supports.
TEST(RailDeflection, BeamAgreesWithPublishedReceptance) {
  auto d = cases::loadCase("smooth-rail");
  d.track.length = 40;
  d.pad.length = 0.02, d.pad.longitudinalStiffness = 0, d.pad.longitudinalDamping = 0;
  d.sleeper.material.young = 1e16;
  std::vector<double> sleepers;
  for (int i = -33; i <= 33; ++i) sleepers.push_back(0.6 * i);
  const TrackBeam beam(d, {69.77e-4, 2337.9e-8, 0.0751, 0.40}, -20, sleepers);
  // Sleepers bear their weight evenly, pads in the middle of the wheel's side do not: a rigid half sleeper whose slope
  // is held at the symmetry plane only goes up and down.
  EXPECT_NEAR(-beam.deflection(0, 0, 1, false), 1.000e-8, 0.01e-8);
  EXPECT_NEAR(-beam.deflection(0.3, 0.3, 1, false), 1.045e-8, 0.01e-8);
  EXPECT_NEAR(std::abs(beam.receptance(0, 50)), 1.295e-8, 0.02 * 1.295e-8);
  EXPECT_NEAR(std::abs(beam.receptance(0.3, 50)), 1.337e-8, 0.02 * 1.337e-8);
  EXPECT_NEAR(std::abs(beam.receptance(0, 300)), 2.475e-9, 0.04 * 2.475e-9);
  EXPECT_NEAR(std::abs(beam.receptance(0, 1000)), 1.030e-9, 0.07 * 1.030e-9);  // half a decibel, on a steep flank
  double peak = 0, at = 0;
  for (double f = 980; f <= 1060; f += 2) {
    const double now = std::abs(beam.receptance(0.3, f));
    if (now > peak) peak = now, at = f;
  }
  EXPECT_NEAR(at, 1018, 0.01 * 1018);
}

}  // namespace
}  // namespace squat::verification
