// solver/dynamics/StableStep.h - the largest stable step of the central difference, from the assembled operator:
// solids, ties, force elements by their stiffest tangents, dashpots. Contact shortens it only where penalties are so
// stiff that the mass which answers for them would be too heavy: see ContactInertia.h. Short waves count with the
// inertia that the case gives them: see SelectiveMassScaling.h.
#pragma once

#include <string>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"
#include "elasticity/SweptKernel.h"
#include "model/Model.h"

namespace squat::dynamics {

struct StableStep {
  double highestFrequency = 0;  // [rad/s] of the undamped model, contact open
  double beta = 0;              // [s] stiffness-proportional damping that the case asks for: a share of critical counts
                                //     at the highest frequency without more inertia for short waves
  double step = 0;              // [s] with safety and damping: 0.95 (2/w) (sqrt(1 + z^2) - z), z = beta w / 2;
                                //     shorter where dashpots of force elements ask for it, or
                                //     penalties of the contact
  std::string location;         // what sets it: part with the keys that size it, block and position
  int iterations = 0;
};

// Lanczos steps on M_e^-1 K in the inner product of the effective mass until the largest eigenvalue changes by less
// than 1e-4; Lanczos values approach from below, hence the factor 0.95.
StableStep stableStep(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                      Monitor& monitor);

}  // namespace squat::dynamics
