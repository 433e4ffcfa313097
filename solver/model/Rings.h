// solver/model/Rings.h - rings of nodes all around the axis of the wheelset: bearing seat, hub, wheel centre.
#pragma once

#include "model/Model.h"

namespace squat::model {

// Nodes of a seat of the wheel body around two lateral positions, weighed such that an even load between these has its
// resultant and its middle.
Ring seatRing(const elasticity::SweptBlock& body, int block, double radius, double from, double to);

// Where the mass sits that neither the solids nor the parts of the case weigh: nodes of the axle's surface from 0.25 to
// 0.85 of the way to the track centre, each weighed by the length that belongs to it.
Ring axleMassRing(const scenario::Wheelset& wheelset, const elasticity::SweptBlock& body, int block);

// The section of a seat at y: the ring of nodes there, or the two beside it.
Ring sectionRing(const elasticity::SweptBlock& body, int block, double radius, double y);

// Where the brake discs of the case sit: the sections of the axle's surface at their places.
std::vector<Ring> discRings(const scenario::Wheelset& wheelset, const elasticity::SweptBlock& body, int block);

}  // namespace squat::model
