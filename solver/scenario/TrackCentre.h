// solver/scenario/TrackCentre.h - where the track lies.
#pragma once

#include "scenario/Motion.h"
#include "scenario/Track.h"

namespace squat::scenario {

// [m] x of the middle of the rail: the sleeper nearest to the middle of the run, so that both ends are alike. The rail
// reaches half of track.length to both sides of it.
double trackCentre(const Track& track, const Motion& motion);

// The sleepers of the model, counted from the one nearest to the defect, positive in rolling direction.
struct SleeperRange {
  int first = 0, last = 0;
};
SleeperRange sleepersOf(const Track& track, const Pad& pad, const Motion& motion);

}  // namespace squat::scenario
