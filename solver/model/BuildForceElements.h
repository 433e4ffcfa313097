// solver/model/BuildForceElements.h - rail pads, ballast and absorbing rail ends as force elements spread over their
// footprint, axle bearing and primary suspension.
#pragma once

#include "model/Model.h"

namespace squat::model {

// Marks the nodes on which outer forces act and lays out the force buffer. Needs blocks, ties and surfaces.
void layOutForces(Model& model);

// Fills model.forceElements, force slots included.
void addForceElements(Model& model);

// Fixes the ends of the rail where they are clamped.
void fixRailEnds(Model& model);

// Where the force on a state unknown is collected in the force buffer.
std::size_t forceSlot(const Model& model, std::size_t stateIndex);

}  // namespace squat::model
