// solver/model/BuildSupports.h - pads, ballast and rail ends as springs spread over their footprint.
#pragma once

#include "model/Model.h"

namespace squat::model {

// Marks the nodes on which outer forces act and lays out the force buffer. Needs blocks, ties and surfaces.
void layOutForces(Model& model);

// Adds pads, ballast and what holds the rail's ends; fills the springs' force slots.
void addSupports(Model& model);

// Where the force on a state unknown is collected in the force buffer.
std::size_t forceSlot(const Model& model, std::size_t stateIndex);

}  // namespace squat::model
