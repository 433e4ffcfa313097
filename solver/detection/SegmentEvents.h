// solver/detection/SegmentEvents.h - the events of one channel of one segment, not yet judged.
#pragma once

#include <vector>

#include "detection/Event.h"
#include "detection/Segments.h"
#include "detection/WavyStretches.h"

namespace squat::detection {

// Root mean square, largest value and largest evidence (Candidates.h) of one channel over equal pieces of the way: for
// the overview along the track, and for what the record reaches where nothing happens (EvidenceTail.h).
struct Piece {
  double position = 0;  // [m] of its beginning, as the record counts
  double rms = 0, peak = 0;
  double evidence = 0;
};

struct SegmentEvents {
  std::vector<Event> events;  // in the segment's core, in their order
  std::vector<Piece> pieces;
  std::vector<WavyStretch> waves;  // of the core, not joined yet
};

inline constexpr double pieceLength = 1;  // [m]

SegmentEvents segmentEvents(const Segment& segment, std::size_t channel, double threshold);

// The features of a passage over one defect, without noise: `position` [m] at each sample, zero at the deepest point;
// `offset` [m] gets the anchor's position. Throws SignalError.
EventFeatures passageFeatures(const signals::TimeSeries& passage, const std::vector<double>& position, double& offset);

}  // namespace squat::detection
