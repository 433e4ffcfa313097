// solver/project/EventList.h - the list of events of long records, squats.json, as a project reads it again.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace squat::project {

// As detection::writeDetection() writes it: rounded, and without the signal over the event.
struct ListedEvent {
  double position = 0;          // [m]
  double time = 0;              // [s]
  std::string record, channel;  // the record's file, as it was called then
  std::string kind, severity;   // "squat", "moderate"; severity of a squat alone
  std::string reason;           // of the kind, where the surroundings decided it; may be empty
  double sureness = 0;          // 0..1
  double peak = 0;              // [m/s2]
  double speed = 0;             // [m/s]
  // [m] of a squat, with their 90 % ranges.
  double length = 0, lengthLow = 0, lengthHigh = 0;
  double depth = 0, depthLow = 0, depthHigh = 0;
  double impact = 0;                   // [m] from the deepest point of a squat, in the direction of travel, to `time`
  std::array<double, 3> severities{};  // probability of light, moderate, severe; zeros: an older list has none
  std::string side;                    // "left", "right", "both" of a wheelset with two channels; else empty
  double sideSureness = 0;             // 0..1
  double extent = 0;                   // [m] of a stretch of corrugation; else 0
  int passes = 1, passesThere = 1;
};

struct EventList {
  std::vector<std::string> records;
  std::vector<ListedEvent> events;
};

// At most 64 MB. Throws FileError with line or key ("/events/3/kind") where it is no such list, something is missing,
// of a wrong kind or out of range.
EventList readEventList(const std::string& path);
EventList parseEventList(const std::string& text, const std::string& origin);

}  // namespace squat::project
