// solver/case/TrackCentre.h - where the track lies.
#pragma once

#include "case/CaseDescription.h"

namespace squat::cases {

// [m] x of the middle of the rail: the sleeper nearest to the middle of the run, so that both ends are alike. The rail
// reaches half of track.length to both sides of it.
double trackCentre(const CaseDescription& description);

// The sleepers of the model, counted from the one nearest to the defect, positive in rolling direction.
struct SleeperRange {
  int first = 0, last = 0;
};
SleeperRange sleepersOf(const CaseDescription& description);

}  // namespace squat::cases
