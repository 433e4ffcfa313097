#include "statics/QuietStart.h"

#include <cmath>

#include "elasticity/SweptWork.h"

namespace squat::statics {

namespace {

// The wheelset's displacements are kept in bases that have turned with the wheel: turned into those of rotation zero.
void turnBack(const model::Model& model, double rotation, AlignedVector& u) {
  const double c = std::cos(rotation), s = std::sin(rotation);
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n)
      for (int k = 0; k < block.stationCount; ++k) {
        double &along = u[block.index(n, 0, k)], &radial = u[block.index(n, 1, k)];
        const double a = along, r = radial;
        along = c * a - s * r;
        radial = s * a + c * r;
      }
  }
  elasticity::refreshGhosts(model.blocks, u.data());
}

}  // namespace

QuietStart prepareQuietStart(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                             Monitor& monitor) {
  const auto& d = model.description;
  QuietStart start;
  start.equilibrium = findEquilibrium(model, kernels, team, model.startX, 0, {}, monitor);
  start.velocity.assign(model.stateSize, 0.0);
  if (start.equilibrium.cancelled) return start;
  const double distance = d.mesh.contactSize, turn = distance / d.wheelset.radius;
  for (const int side : {1, -1}) {
    EquilibriumOptions options;
    options.guess = &start.equilibrium.displacement;
    options.tolerance = 1e-6;  // of the load: velocities then err by about a micrometre per second
    auto other = findEquilibrium(model, kernels, team, model.startX + side * distance, side * turn, options, monitor);
    if (other.cancelled) {
      start.equilibrium.cancelled = true;
      return start;
    }
    turnBack(model, side * turn, other.displacement);
    for (std::size_t i = 0; i < model.stateSize; ++i)
      start.velocity[i] += side * other.displacement[i] * d.motion.speed / (2 * distance);
  }
  model::removeSpin(model, model::meanSpin(model, start.velocity.data()), start.velocity.data());
  return start;
}

}  // namespace squat::statics
