// solver/detection/Passes.h - several passes over one place: their events, as one list.
#pragma once

#include <vector>

#include "detection/Detect.h"

namespace squat::detection {

// An event of the combined list: the passes' events that are one place, the strongest first.
struct CombinedEvent {
  Event event;  // of the strongest; its position is the mean of all, in the first record's chainage
  std::vector<std::size_t> records;  // in which it was found
  double scatter = 0;                // [m] largest distance of a pass's own position from the mean, once aligned
};

// Records that cover common chainage are passes of one place: each is moved as a whole to where its events meet those
// of the first (the counters of two trains differ by metres), then event by event to where the signals match. Kind and
// severity go by the sum of the passes' probabilities. Records without common chainage are listed one behind the other.
std::vector<CombinedEvent> combine(const std::vector<RecordDetection>& detections);

}  // namespace squat::detection
