#include "statics/UnloadedShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/Errors.h"
#include "statics/ConjugateGradients.h"

namespace squat::statics {

UnloadedShape findUnloadedShape(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                                const plasticity::LayerForces& forces, Monitor& monitor) {
  constexpr double tolerance = 1e-7;  // of the plastic forces
  constexpr int maximumIterations = 20000;
  UnloadedShape shape;
  shape.displacement.assign(model.stateSize, 0.0);
  AlignedVector force(model.stateSize, 0.0);
  const auto& rail = model.blocks[model.rail];
  std::vector<int> everyNode(rail.nodes);
  std::iota(everyNode.begin(), everyNode.end(), 0);
  AlignedVector lines(rail.lines() * rail.stride, 0.0);
  plasticity::addPlasticForces(model.layer, forces, 0, rail.intervals, lines.data(), everyNode.data());
  for (int n = 0; n < rail.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; s < rail.stationCount; ++s)
        force[rail.index(n, c, s)] = lines[(static_cast<std::size_t>(n) * 3 + c) * rail.stride + s];

  model::StaticOperator op(model, kernels, team, 0, 1e8, true);
  CoarseSpace coarse(model, op);
  if (!coarse.assemble(op, monitor)) {
    shape.cancelled = true;
    return shape;
  }
  // No contact carries the vehicle: one spring fixes the sprung mass, and with it the wheelset. Nothing pushes them:
  // the spring keeps its length, and any stiffness will do.
  op.contactSprings().add({{model.sprungZ, 1.0}}, model.scenario.suspension.stiffness, 0);
  coarse.factorise(op.contactSprings());
  op.reduceForces(force.data());
  const double norm = std::sqrt(std::inner_product(force.begin(), force.end(), force.begin(), 0.0));
  if (norm == 0) return shape;
  const auto solution = conjugateGradients(
      op, coarse, force, shape.displacement, tolerance * norm, maximumIterations, [&](int, double residual) {
        Progress progress;
        progress.phase = "unloading";
        progress.fraction = std::clamp(std::log(norm / residual) / std::log(1 / tolerance), 0.0, 1.0);
        monitor.report(progress);
        return !monitor.cancelled();
      });
  shape.iterations = solution.iterations, shape.residual = solution.residual / norm;
  shape.cancelled = solution.cancelled;
  if (!shape.cancelled && !(solution.residual <= tolerance * norm))
    throw RunError("the unloaded rail does not converge: residual " + std::to_string(shape.residual) +
                       " of the plastic forces after " + std::to_string(shape.iterations) + " iterations",
                   0, 0, "unloading");
  op.fillSlaves(shape.displacement.data());
  return shape;
}

}  // namespace squat::statics
