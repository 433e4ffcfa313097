#include "statics/SteadyRollingStart.h"

#include <algorithm>
#include <cmath>

namespace squat::statics {

namespace {

// Rolled over single elements, a patch of few points comes and goes: the approach of wheel and rail ripples by a micron
// or two within an element. Its slope is part of the equilibrium's rate, and as a velocity of the whole vehicle it
// would shake the wheel for the length of the run-up. Under a constant load the approach is constant: the wheel rises
// and falls with the deflected rail, averaged over more than an element.
constexpr double window = 0.025;  // [m] to either side of the wheel: longer than the patch and the elements of any mesh

// Mean vertical displacement of the rail's section at a station [m].
double verticalOfSection(const model::Model& model, const AlignedVector& u, int station) {
  const auto& rail = model.blocks[model.rail];
  double sum = 0, mass = 0;
  for (int n = 0; n < rail.nodes; ++n) {
    const double m = model.mass[model.rail][n * rail.stride + station];
    sum +=
        m * (std::sin(rail.lean) * u[rail.index(n, 1, station)] + std::cos(rail.lean) * u[rail.index(n, 2, station)]);
    mass += m;
  }
  return sum / mass;
}

double verticalAt(const model::Model& model, const AlignedVector& u, double x) {
  const auto& rail = model.blocks[model.rail];
  const auto it = std::upper_bound(rail.positions.begin(), rail.positions.end(), x);
  const int s = std::clamp(static_cast<int>(it - rail.positions.begin()) - 1, 0, rail.intervals - 1);
  const double share = (x - rail.positions[s]) / (rail.positions[s + 1] - rail.positions[s]);
  return (1 - share) * verticalOfSection(model, u, s) + share * verticalOfSection(model, u, s + 1);
}

// Mean displacement over a window that moves with the wheel: its change per metre [1], of displacements and their rate.
double railRate(const model::Model& model, const AlignedVector& u, const AlignedVector& rate, double x) {
  constexpr int points = 40;
  double sum = 0;
  for (int i = 0; i < points; ++i) sum += verticalAt(model, rate, x + window * ((2 * i + 1.0) / points - 1)) / points;
  return sum + (verticalAt(model, u, x + window) - verticalAt(model, u, x - window)) / (2 * window);
}

// The whole vehicle moves upwards by as much [u's unit].
void addVertical(const model::Model& model, double upwards, AlignedVector& u) {
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s) {
      const Eigen::Vector3d local =
          elasticity::localBasis(block, block.positions[s]).transpose() * Eigen::Vector3d(0, 0, upwards);
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 2; ++c) u[block.index(n, c, s)] += local[c];
    }
  }
  u[model.sprungZ] += upwards;
  if (model.boxOnSpring()) u[model.boxZ] += upwards;
}

}  // namespace

SteadyRollingStart prepareSteadyRollingStart(const model::Model& model, const elasticity::KernelSet& kernels,
                                             ThreadTeam& team, Monitor& monitor) {
  const auto& d = model.scenario;
  SteadyRollingStart start;
  start.equilibrium = findEquilibrium(model, kernels, team, model.startX, 0, {}, monitor);
  start.velocity.assign(model.stateSize, 0.0);
  if (start.equilibrium.cancelled) return start;
  start.velocity = equilibriumRate(model, kernels, team, start.equilibrium, monitor);
  start.equilibrium.cancelled = monitor.cancelled();
  if (start.equilibrium.cancelled) return start;
  model::TurnedStations turned;
  model::turnStations(model.blocks[model.body], 0, turned);
  const double wheelRate = model::ringMean(model, model.centre, turned, start.velocity.data()).z;
  addVertical(model,
              railRate(model, start.equilibrium.displacement, start.velocity, start.equilibrium.wheelX) - wheelRate,
              start.velocity);
  for (double& value : start.velocity) value *= d.motion.speed;
  model::removeMeanRotation(model, model::meanRotation(model, start.velocity.data()), start.velocity.data());
  return start;
}

}  // namespace squat::statics
