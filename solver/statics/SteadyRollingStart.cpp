#include "statics/SteadyRollingStart.h"

namespace squat::statics {

SteadyRollingStart prepareSteadyRollingStart(const model::Model& model, const elasticity::KernelSet& kernels,
                                             ThreadTeam& team, Monitor& monitor) {
  const auto& d = model.scenario;
  SteadyRollingStart start;
  start.equilibrium = findEquilibrium(model, kernels, team, model.startX, 0, {}, monitor);
  start.velocity.assign(model.stateSize, 0.0);
  if (start.equilibrium.cancelled) return start;
  start.velocity = equilibriumRate(model, kernels, team, start.equilibrium, monitor);
  start.equilibrium.cancelled = monitor.cancelled();
  for (double& value : start.velocity) value *= d.motion.speed;
  model::removeMeanRotation(model, model::meanRotation(model, start.velocity.data()), start.velocity.data());
  return start;
}

}  // namespace squat::statics
