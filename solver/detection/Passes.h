// solver/detection/Passes.h - several passes over one location: their events, as one list.
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

// [m] to add to the positions of each record, so that as many of its events as possible meet those of the first (the
// counters of two trains differ by metres, up to ten); zero where fewer than two meet. Strikes of a wheel flat, which
// are elsewhere in each pass, do not count where they are known.
std::vector<double> shiftsOntoFirst(const std::vector<RecordDetection>& detections);

// Records that cover common chainage are passes of one location: each is moved as a whole onto the first, then event by
// event to where the signals match. Kind and severity go by the sum of the passes' probabilities, or by the label of
// one of them; length and depth are those of the strongest event with that severity. Records without common chainage
// are listed one behind the other.
std::vector<CombinedEvent> combine(const std::vector<RecordDetection>& detections);

// How many of the records pass a position [m] in the first one's chainage. `shifts`: shiftsOntoFirst().
std::size_t passesAt(const std::vector<RecordDetection>& detections, const std::vector<double>& shifts,
                     double position);

}  // namespace squat::detection
