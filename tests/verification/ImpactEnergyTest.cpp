// A frictionless, undamped impact of the wheel on the track keeps its energy.
// Theory: conservation of energy; the central difference keeps it to second order in the step. The wheelset is
// thrown on the rail while it rolls; kinetic, strain and contact energy and the work of the weight must close.
// Tolerance 0.1 % of the strain energy at equilibrium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/CaseFile.h"
#include "dynamics/StableStep.h"
#include "simulation/EnergyLedger.h"
#include "statics/QuietStart.h"

namespace squat::simulation {
namespace {

cases::CaseDescription conservativeCase() {
  auto d = cases::loadCase("smooth-rail", {"tiny", {}});
  d.contact.friction = 0;
  d.motion.torque = 0, d.motion.tractionCoefficient = 0;
  d.damping.fraction = 0, d.damping.beta = 0;
  for (cases::Support* support : {static_cast<cases::Support*>(&d.pad), &d.ballast})
    support->damping = support->lateralDamping = support->longitudinalDamping = 0;
  d.suspension.damping = d.suspension.longitudinalDamping = 0;
  return d;
}

TEST(ImpactEnergy, IsKeptThroughAnImpact) {
  const auto description = conservativeCase();
  const auto model = model::buildModel(description);
  ThreadTeam team(1);
  Monitor quiet;
  const auto kernels = elasticity::kernelsFor("");
  const auto stable = dynamics::stableStep(model, kernels, team, quiet);
  auto start = statics::prepareQuietStart(model, kernels, team, quiet);
  // The whole wheelset thrown downwards: the force doubles, 43 J go over into the track.
  constexpr double thrown = -0.3;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s) {
      const Eigen::Vector3d local =
          elasticity::localBasis(block, block.positions[s]).transpose() * Eigen::Vector3d(0, 0, thrown);
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 2; ++c) start.velocity[block.index(n, c, s)] += local[c];
    }
  }
  elasticity::refreshGhosts(model.blocks, start.velocity.data());

  dynamics::Rolling rolling(model, kernels, team, stable.step, stable.beta);
  rolling.start(start.equilibrium.displacement, start.velocity, description.motion.speed / description.wheelset.radius);
  EnergyLedger ledger(rolling, start.equilibrium.strainEnergy);
  double most = 0;
  const auto watch = [&](const dynamics::StepView& view) { most = std::max(most, view.patch.vertical); };
  const double load = start.equilibrium.contactForce;
  while (rolling.state().time < 2e-3) {
    ledger.before(rolling);
    rolling.advance(1, watch);
    ledger.after(rolling);
    rolling.advance(39, watch);
  }
  EXPECT_GT(most, 1.8 * load);
  EXPECT_LT(ledger.largestRelativeResidual(), 1e-3);
  RecordProperty("relative_residual", std::to_string(ledger.largestRelativeResidual()));
}

}  // namespace
}  // namespace squat::simulation
