// solver/scenario/SleeperHeight.h - how high a sleeper is along its length.
//
// The base is flat. The top is level in the middle of the track, up to middleHalfLength from its centre, rises in a
// straight line to the inner edge of the rail pad, and is level from there to the end.
#pragma once

#include <vector>

#include "scenario/Scenario.h"

namespace squat::scenario {

// [m] from the track centre: where the sleeper has its full height.
inline double fullHeightFrom(const Inputs& inputs) { return inputs.wheelset.trackCentre - 0.5 * inputs.pad.width; }

// At each station, a distance from the track centre [m], ascending from 0 to the end: the mean height about it, as a
// share of the height under the rail. Weighed with the linear shape function of the station, so that straight lines
// between the stations enclose the volume of the sleeper itself, wherever its edges lie. Empty: even height.
std::vector<double> sleeperHeightShares(const Inputs& inputs, const std::vector<double>& distances);

}  // namespace squat::scenario
