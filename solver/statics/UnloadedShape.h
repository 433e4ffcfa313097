// solver/statics/UnloadedShape.h - what plastic strain leaves behind when the wheel is gone.
#pragma once

#include <memory>

#include "core/Monitor.h"
#include "model/StaticOperator.h"
#include "plasticity/LayerWork.h"
#include "statics/StaticSystem.h"

namespace squat::statics {

struct UnloadedShape {
  AlignedVector displacement;  // state layout [m], the weight of the track left out
  double residual = 0;         // 2-norm relative to the forces of the plastic strain
  int iterations = 0;
  bool cancelled = false;
};

// K u = f_p: the elastic track without wheel and weight under the forces of the plastic strain alone, by the conjugate
// gradients of the equilibrium. Elements do not yield again on the way: unloading is elastic.
UnloadedShape findUnloadedShape(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                                const plasticity::LayerForces& forces, Monitor& monitor);

// The same again and again, as plastic strain grows: only what is new is solved for.
class UnloadedShapes {
 public:
  // Keeps references to the model and the team.
  UnloadedShapes(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team);
  // Before the first follow(): false where it was cancelled.
  bool prepare(Monitor& monitor);
  // Goes on from `shape`, which is that of the forces of the last call (or empty, and these were zero). What is new is
  // found to `tolerance` of itself.
  void follow(const plasticity::LayerForces& forces, double tolerance, UnloadedShape& shape, Monitor& monitor);
  // Forces of a shape that stands: the next follow() goes on from there.
  void startFrom(const plasticity::LayerForces& forces);

 private:
  AlignedVector forcesOf(const plasticity::LayerForces& forces);

  const model::Model& model_;
  HalfSystem system_;
  AlignedVector last_;
};

}  // namespace squat::statics
