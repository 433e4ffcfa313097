// solver/detection/Detect.h - from a long record to the list of its events.
#pragma once

#include <string>
#include <vector>

#include "core/Monitor.h"
#include "detection/Axles.h"
#include "detection/BackgroundSections.h"
#include "detection/Event.h"
#include "detection/SegmentEvents.h"
#include "detection/Surroundings.h"
#include "records/RecordStream.h"

namespace squat::detection {

struct DetectOptions {
  double threshold = 14;     // least evidence that makes a candidate (Candidates.h)
  double falseAlarms = 0.1;  // [1/km] of the background: what it reaches more often is no event
  int threads = 0;           // 0: all cores
  double leastShare = 0.9;   // of a record's samples that must be readable; below it FileError
  AxleNames axles;           // of all records
  SurroundingsOptions surroundings;
};

struct ChannelDetection {
  std::string name;
  std::vector<Event> events;  // in the order of travel
  std::vector<Piece> pieces;  // along the track
  double circumference = 0;   // [m] at which flats repeat; 0: none
  std::vector<WavyStretch> waves = {};
  std::vector<BackgroundSection> background = {};  // once it is judged
};

struct RecordDetection {
  records::RecordLayout layout;
  std::vector<ChannelDetection> channels;
  std::vector<Axle> axles;
  std::vector<records::RecordFault> faults;
  std::vector<std::string> notes;
  double duration = 0, length = 0;  // [s], [m] that were analysed
  bool cancelled = false;
};

// Reads the stream to its end; memory grows with its events, not with its length. The events are candidates, not judged
// yet. Reports progress; cancelled: what was found so far. Throws what the stream throws.
RecordDetection findCandidates(records::RecordStream& stream, const DetectOptions& options, Monitor& monitor);

// Gives each label to the nearest candidate within half a metre; returns for each whether there is one. `shift` [m]: to
// add to the record's positions for those of the labels, where more of them meet an event with it than without.
std::vector<bool> attachLabels(RecordDetection& detection, const std::vector<Label>& labels, double shift = 0);

// The labelled candidates as examples of their own vehicle, each as heavy as `weight` others. A squat whose size the
// label does not say has length and depth 0.
std::vector<Example> labelledExamples(const RecordDetection& detection, double weight);

// Judges the candidates by the examples and their surroundings; drops those that are noise. What is labelled stays,
// with kind and severity as the label has them. Reports progress; cancelled: false, and nothing is judged that can be
// used.
bool judgeCandidates(RecordDetection& detection, const Judge& judge, const DetectOptions& options, Monitor& monitor);

}  // namespace squat::detection
