// solver/detection/Event.h - a place of a record that is louder than around, and what it is taken for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detection/AxleSides.h"
#include "detection/EventFeatures.h"
#include "detection/Examples.h"
#include "detection/Label.h"
#include "signals/TimeSeries.h"

namespace squat::detection {

struct Event {
  std::string channel, unit;
  double time = 0, position = 0;       // [s]; [m] as the record counts, of the cause (not of the signal's peak)
  double travelled = 0;                // [m] along the run, from an arbitrary zero
  double latitude = 0, longitude = 0;  // [deg]; not-a-number where the record has none
  double score = 0;                    // evidence (Candidates.h)
  double falseAlarms = 0;              // [1/km] how often the background alone makes as much (EvidenceTail.h)
  double peak = 0;                     // [unit] largest absolute value around, up to 2 kHz
  EventFeatures features;
  std::optional<FirstArrival> arrival;  // of this axle box and the other one of the wheelset; nothing: not known
  std::string axle;                     // the two channels of the wheelset; empty: not known
  double otherPeak = 0;                 // [unit] as `peak`, of the other axle box
  std::optional<SideJudgement> side;    // once it is judged, where `arrival` is known
  Judgement judgement;
  Kind kind = Kind::other;
  double sureness = 0;
  std::string reason;           // where it was not the signal: "repeats every 2.89 m", "as labelled"
  std::optional<Label> label;   // decides kind and severity
  double extent = 0;            // [m] along the track from its position, of a stretch of corrugation; else 0
  signals::TimeSeries passage;  // the signal half a metre ahead of it to a metre behind
  std::size_t passes = 1;       // that have it, of those that passed there
  std::size_t passesThere = 1;
};

}  // namespace squat::detection
