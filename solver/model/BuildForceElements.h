// solver/model/BuildForceElements.h - the force elements of the track, spread over their footprint (rail pads, ballast,
// absorbing rail ends), and of the vehicle (axle bearing, primary suspension).
#pragma once

#include "model/Model.h"

namespace squat::model {

// Auxiliary degrees of freedom at the end of state and force buffer (Model.h): six, and two unused ones that fill a
// vector.
constexpr std::size_t auxiliaryUnknowns = 8;

// Marks the nodes on which outer forces act and lays out the force buffer. Needs blocks, ties and surfaces.
void layOutForces(Model& model);

// Fills model.forceElements, force slots included.
void addForceElements(Model& model);

// Pads and ballast alone, without force slots: for solutions in the frequency domain.
void addSupports(Model& model);

// Fixes the ends of the rail where they are clamped.
void fixRailEnds(Model& model);

// Where the force on a state unknown is collected in the force buffer.
std::size_t forceSlot(const Model& model, std::size_t stateIndex);

}  // namespace squat::model
