// solver/statics/SteadyRollingStart.h - displacements and the velocities that steady rolling through them implies.
//
// The equilibrium at the start and its rate as the wheel rolls on: rate times speed is the velocity of every node. The
// vehicle as a whole follows the deflection of the rail, not the elements under the wheel. Rolling then starts without
// vibration.
#pragma once

#include "statics/Equilibrium.h"

namespace squat::statics {

struct SteadyRollingStart {
  Equilibrium equilibrium;  // at the start
  AlignedVector velocity;   // state layout [m/s]
};

// Of every half of a system at rotation zero, which it assembles.
std::vector<SteadyRollingStart> prepareSteadyRolling(StaticSystem& system, Monitor& monitor);
// Of a half model.
SteadyRollingStart prepareSteadyRollingStart(const model::Model& model, const elasticity::KernelSet& kernels,
                                             ThreadTeam& team, Monitor& monitor);

}  // namespace squat::statics
