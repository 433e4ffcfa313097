// solver/statics/UnloadedShape.h - what plastic strain leaves behind when the wheel is gone.
#pragma once

#include "core/Monitor.h"
#include "model/StaticOperator.h"
#include "plasticity/LayerWork.h"

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

}  // namespace squat::statics
