#include "case/TrackCentre.h"

#include <cmath>

namespace squat::cases {

double trackCentre(const CaseDescription& d) {
  const double middle = 0.5 * (d.motion.beyond - d.motion.runUp), spacing = d.track.sleeperSpacing;
  const double first = -d.track.defectFromSleeper;
  return first + spacing * std::round((middle - first) / spacing);
}

SleeperRange sleepersOf(const CaseDescription& d) {
  const double spacing = d.track.sleeperSpacing;
  const int middle = static_cast<int>(std::lround((trackCentre(d) + d.track.defectFromSleeper) / spacing));
  const int each = static_cast<int>(std::floor((d.track.length / 2 - d.pad.length / 2) / spacing + 1e-9));
  return {middle - each, middle + each};
}

}  // namespace squat::cases
