// solver/detection/SegmentEvents.h - the events of one channel of one segment, not yet judged.
#pragma once

#include <vector>

#include "detection/Event.h"
#include "detection/Segments.h"

namespace squat::detection {

// Root mean square and largest value of one channel over equal pieces of the way, for the overview along the track.
struct Piece {
  double position = 0;  // [m] of its beginning, as the record counts
  double rms = 0, peak = 0;
};

struct SegmentEvents {
  std::vector<Event> events;  // in the segment's core, in their order
  std::vector<Piece> pieces;
};

// Stretches slower than `minimumSpeed` are passed over: a wheel that barely moves excites nothing that can be judged.
inline constexpr double minimumSpeed = 3;  // [m/s]
inline constexpr double pieceLength = 1;   // [m]

SegmentEvents segmentEvents(const Segment& segment, std::size_t channel, double threshold);

// The features of a passage over one defect, without noise: `position` [m] at each sample, zero at the deepest point;
// `offset` [m] gets the anchor's position. Throws SignalError.
EventFeatures passageFeatures(const signals::TimeSeries& passage, const std::vector<double>& position, double& offset);

}  // namespace squat::detection
