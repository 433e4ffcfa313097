// What the ends of the rail send back of a wave along it.
//
// Theory: d'Alembert's wave in a bar, c = sqrt(E / rho). An end with the impedance Z' sends back (Z - Z') / (Z + Z') of
// the displacement, Z = rho c A: all of it where it is free (Z' = 0), all of it with the other sign where it is clamped
// (Z' infinite), nothing where dashpots take rho c A. Lateral inertia makes the section stiffer by (nu k r)^2 / 2, r
// its polar radius of gyration, 63 mm: 0.3 % at the pulse's middle wave number 1 / 0.25 m, 1.1 % at twice that.
// Tolerance 2 % for it, for elements of 25 mm and for lateral dashpots, which brake the contraction next to the end.
//
// The rail by itself: no pads, no weight, the wheel lifted off.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "dynamics/Rolling.h"
#include "dynamics/StableStep.h"
#include "elasticity/SweptSamples.h"
#include "verification/Seen.h"

namespace squat::verification {
namespace {

constexpr double pulseWidth = 0.25, pulseHeight = 1e-5;  // [m] standard deviation and height of the pulse

model::Model bareRail(const char* ends) {
  auto d = cases::loadScenario(
      tests::fixtureCase("smooth-rail"),
      {"tiny", {{"track.rail_ends", ends}, {"track.length", "6"}, {"mesh.far_size", "25"}, {"damping.fraction", "0"}}});
  d.motion.gravity = d.motion.torque = 0;
  d.pad.stiffness = d.pad.longitudinalStiffness = d.pad.lateralStiffness = 0;
  d.pad.damping = d.pad.longitudinalDamping = d.pad.lateralDamping = 0;
  return model::buildModel(d);
}

double railPulse(double x) { return pulseHeight * std::exp(-0.5 * std::pow(x / pulseWidth, 2)); }

// Lifted by 2 mm, at rest.
void liftWheelset(const model::Model& model, AlignedVector& displacement) {
  for (const int b : {model.rim, model.body})
    elasticity::setField(
        model.blocks[b], [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 0.002); }, displacement);
  displacement[model.sprungZ] = 0.002;
}

struct Returned {
  double share = 0;    // of the pulse's height, by the pulse's own shape
  double largest = 0;  // of any displacement along the rail, of the pulse's height
};

// A pulse that runs from the middle of the rail to its right end, and what has come back to the middle when it has had
// the time to.
Returned returnedFrom(const char* ends) {
  const auto model = bareRail(ends);
  const auto& rail = model.blocks[model.rail];
  const double nu = rail.material.poisson, speed = std::sqrt(rail.material.young / rail.material.density);
  const auto section = geometry::sectionIntegrals(rail.section);
  const double middle = 0.5 * (rail.positions.front() + rail.positions.back());
  ThreadTeam team(1);
  Monitor quiet;
  const auto stable = dynamics::stableStep(model, elasticity::kernelsFor(""), team, quiet);
  dynamics::Rolling rolling(model, elasticity::kernelsFor(""), team, stable.step, 0);
  AlignedVector u(model.stateSize, 0.0), v(model.stateSize, 0.0);
  constexpr double h = 1e-4;
  const auto slope = [&](double x) { return (railPulse(x + h) - railPulse(x - h)) / (2 * h); };
  const auto curvature = [&](double x) { return (railPulse(x + h) - 2 * railPulse(x) + railPulse(x - h)) / (h * h); };
  // The section contracts about its centroid by nu times the strain.
  const auto contracted = [&](const Eigen::Vector3d& p, double along, double across) {
    return Eigen::Vector3d(along, -nu * (p[1] - section.centroidB) * across, -nu * (p[2] - section.centroidC) * across);
  };
  elasticity::setField(
      rail, [&](const Eigen::Vector3d& p) { return contracted(p, railPulse(p[0] - middle), slope(p[0] - middle)); }, u);
  elasticity::setField(
      rail,
      [&](const Eigen::Vector3d& p) {
        const double x = p[0] - middle + speed * stable.step / 2;  // half a step earlier
        return Eigen::Vector3d(-speed * contracted(p, slope(x), curvature(x)));
      },
      v);
  liftWheelset(model, u);
  rolling.start(u, v, 0);
  rolling.advance(std::lround(model.scenario.track.length / speed / stable.step), [](const dynamics::StepView&) {});

  Returned returned;
  double product = 0, square = 0;
  for (int s = 1; s + 1 < rail.stationCount; ++s) {
    double mean = 0, mass = 0;
    for (int n = 0; n < rail.nodes; ++n) {
      const double m = model.mass[model.rail][static_cast<std::size_t>(n) * rail.stride + static_cast<std::size_t>(s)];
      mean += m * rolling.state().displaced[rail.index(n, 0, s)], mass += m;
    }
    const double own = railPulse(rail.positions[s] - middle);
    const double length = 0.5 * (rail.positions[s + 1] - rail.positions[s - 1]);
    product += length * mean / mass * own, square += length * own * own;
    returned.largest = std::max(returned.largest, std::abs(mean / mass) / pulseHeight);
  }
  returned.share = product / square;
  std::printf("%s: %.4f of the railPulse, largest displacement %.4f\n", ends, returned.share, returned.largest);
  return returned;
}

TEST(RailEnds, AFreeEndSendsBackAllOfIt) {
  const double share = returnedFrom("free").share;
  EXPECT_NEAR(share, 1, 0.02);
  seenDeviation("free", share, 1);
}

TEST(RailEnds, AClampedEndSendsBackAllOfItUpsideDown) {
  const double share = returnedFrom("clamped").share;
  EXPECT_NEAR(share, -1, 0.02);
  seenDeviation("clamped", share, -1);
}

TEST(RailEnds, AnAbsorbingEndSendsBackNothing) {
  const auto returned = returnedFrom("absorbing");
  EXPECT_NEAR(returned.share, 0, 0.02);
  seen("absorbing", 100 * returned.share, "%");
  // Short waves lag behind the pulse and have not reached the end yet: a free end sends 0.94 of the height back at
  // once.
  EXPECT_LT(returned.largest, 0.06);
}

}  // namespace
}  // namespace squat::verification
