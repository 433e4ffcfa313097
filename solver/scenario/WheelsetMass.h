// solver/scenario/WheelsetMass.h - what the half wheelset weighs, part by part, in closed form.
#pragma once

#include <vector>

#include "scenario/Vehicle.h"

namespace squat::scenario {

// The solid half of a wheelset: volume [m3] and the integral of the squared radius over it [m5], times density its
// inertia about the axis.
struct WheelsetSolid {
  double volume = 0, squaredRadii = 0;
};
WheelsetSolid wheelsetSolid(const Wheelset& wheelset);

// [kg] of the stated brake discs, and of solid parts, axle box and these discs.
inline double brakeDiscsMass(const Wheelset& wheelset) { return wheelset.brakeDiscs * wheelset.brakeDiscMass; }
double partsMass(const Wheelset& wheelset);

// [kg] of the half wheelset: as stated, or what its parts weigh.
double wheelsetMass(const Wheelset& wheelset);

// Distances of the discs from the wheel plane towards the track centre [m], ascending. Several are as far from each
// other as the last one is from its mirror image beyond the track centre: evenly along the whole axle.
std::vector<double> brakeDiscPositions(const Wheelset& wheelset);

}  // namespace squat::scenario
