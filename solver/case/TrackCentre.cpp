#include "case/TrackCentre.h"

#include <cmath>

namespace squat::cases {

double trackCentre(const CaseDescription& d) {
  const double middle = 0.5 * (d.motion.beyond - d.motion.runUp), spacing = d.track.sleeperSpacing;
  const double first = -d.track.defectFromSleeper;
  return first + spacing * std::round((middle - first) / spacing);
}

}  // namespace squat::cases
