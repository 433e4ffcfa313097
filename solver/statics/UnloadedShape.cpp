#include "statics/UnloadedShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/Errors.h"
#include "statics/ConjugateGradients.h"

namespace squat::statics {

namespace {

constexpr int maximumIterations = 20000;

double normOf(const AlignedVector& v) { return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0)); }

}  // namespace

UnloadedShapes::UnloadedShapes(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team)
    : model_(model), system_(model, kernels, team, 0) {
  last_.assign(model.stateSize, 0.0);
}

bool UnloadedShapes::prepare(Monitor& monitor) {
  if (!system_.assemble(monitor)) return false;
  // No contact carries the vehicle: one spring fixes the sprung mass, and with it the wheelset. Nothing pushes them:
  // the spring keeps its length, and any stiffness will do.
  system_.op().contactSprings().add({{model_.sprungZ, 1.0}}, model_.scenario.suspension.stiffness, 0);
  system_.factorise();
  return true;
}

// Of the plastic strain, in state layout.
AlignedVector UnloadedShapes::forcesOf(const plasticity::LayerForces& forces) {
  AlignedVector force(model_.stateSize, 0.0);
  const auto& rail = model_.blocks[model_.rail];
  std::vector<int> everyNode(rail.nodes);
  std::iota(everyNode.begin(), everyNode.end(), 0);
  AlignedVector lines(rail.lines() * rail.stride, 0.0);
  plasticity::addPlasticForces(model_.layer, forces, 0, rail.intervals, lines.data(), everyNode.data());
  for (int n = 0; n < rail.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; s < rail.stationCount; ++s)
        force[rail.index(n, c, s)] = lines[(static_cast<std::size_t>(n) * 3 + c) * rail.stride + s];
  system_.op().reduceForces(force.data());
  return force;
}

void UnloadedShapes::startFrom(const plasticity::LayerForces& forces) { last_ = forcesOf(forces); }

void UnloadedShapes::follow(const plasticity::LayerForces& forces, double tolerance, UnloadedShape& shape,
                            Monitor& monitor) {
  if (shape.displacement.empty()) shape.displacement.assign(model_.stateSize, 0.0);
  AlignedVector force = forcesOf(forces), added(force.size());
  for (std::size_t i = 0; i < force.size(); ++i) added[i] = force[i] - last_[i];
  const double norm = normOf(added);
  if (norm == 0) return;
  AlignedVector more(model_.stateSize, 0.0);
  const auto solution =
      conjugateGradients(system_, added, more, tolerance * norm, maximumIterations, [&](int, double residual) {
        Progress progress;
        progress.phase = "unloading";
        progress.fraction = std::clamp(std::log(norm / residual) / std::log(1 / tolerance), 0.0, 1.0);
        monitor.report(progress);
        return !monitor.cancelled();
      });
  shape.iterations = solution.iterations, shape.residual = solution.residual / norm;
  shape.cancelled = solution.cancelled;
  if (shape.cancelled) return;
  if (!(solution.residual <= tolerance * norm))
    throw RunError("the unloaded rail does not converge: residual " + std::to_string(shape.residual) +
                       " of the plastic forces after " + std::to_string(shape.iterations) + " iterations",
                   0, 0, "unloading");
  system_.op().fillSlaves(more.data());
  for (std::size_t i = 0; i < more.size(); ++i) shape.displacement[i] += more[i];
  last_ = std::move(force);
}

UnloadedShape findUnloadedShape(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                                const plasticity::LayerForces& forces, Monitor& monitor) {
  constexpr double tolerance = 1e-7;  // of the plastic forces
  UnloadedShapes shapes(model, kernels, team);
  UnloadedShape shape;
  shape.displacement.assign(model.stateSize, 0.0);
  if (!shapes.prepare(monitor)) {
    shape.cancelled = true;
    return shape;
  }
  shapes.follow(forces, tolerance, shape, monitor);
  return shape;
}

}  // namespace squat::statics
