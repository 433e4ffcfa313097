// solver/detection/SegmentEvents.h - the events of one channel of one segment, not yet judged.
#pragma once

#include <optional>
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

// `other`: the channel of the other axle box of the same wheelset, where there is one.
SegmentEvents segmentEvents(const Segment& segment, std::size_t channel, double threshold,
                            std::optional<std::size_t> other = {});

struct PassageFeatures {
  EventFeatures features;
  double offset = 0;                    // [m] position of the anchor
  std::optional<FirstArrival> arrival;  // where the other axle box is known
};

// The features of a passage over one defect, without noise: `position` [m] at each sample, zero at the deepest point.
// `other`: the signal of the other axle box on the same time axis; null: not known. Throws SignalError.
PassageFeatures passageFeatures(const signals::TimeSeries& passage, const std::vector<double>& position,
                                const signals::TimeSeries* other = nullptr);

}  // namespace squat::detection
