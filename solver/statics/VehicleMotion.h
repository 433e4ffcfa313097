// solver/statics/VehicleMotion.h - rigid vertical motion of the vehicle, mean vertical motion of the rail under it.
#pragma once

#include "model/Model.h"

namespace squat::statics {

// Adds a rigid upward motion of wheelset, axle box and sprung mass to displacements [m] or velocities [m/s] in state
// layout; `rotation` [rad] of the bases of the wheelset.
void addVerticalMotion(const model::Model& model, double rotation, double upwards, double* state);
// Adds a rigid roll of a whole vehicle about the track centre: what one side sees of it, by how much its wheel rises;
// the other side's falls by as much.
void addRoll(const model::Model& model, double rotation, double wheelUpwards, double* state);

// Vertical displacement or velocity of the rail's section at a station, mean over its nodes' masses.
double verticalOfRailSection(const model::Model& model, const AlignedVector& state, int station);

}  // namespace squat::statics
