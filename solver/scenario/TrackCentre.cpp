#include "scenario/TrackCentre.h"

#include <cmath>

namespace squat::scenario {

double trackCentre(const Track& track, const Motion& motion) {
  const double middle = 0.5 * (motion.beyond - motion.runUp), spacing = track.sleeperSpacing;
  const double first = -track.defectFromSleeper;
  return first + spacing * std::round((middle - first) / spacing);
}

SleeperRange sleepersOf(const Track& track, const Pad& pad, const Motion& motion) {
  const double spacing = track.sleeperSpacing;
  const int middle = static_cast<int>(std::lround((trackCentre(track, motion) + track.defectFromSleeper) / spacing));
  const int each = static_cast<int>(std::floor((track.length / 2 - pad.length / 2) / spacing + 1e-9));
  return {middle - each, middle + each};
}

}  // namespace squat::scenario
