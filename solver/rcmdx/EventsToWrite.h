// solver/rcmdx/EventsToWrite.h - found squats as an RCM-DX file, version 2.0.4 of the specification: plain values that
// know nothing of how they were found.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rcmdx/TrackPositions.h"

namespace squat::rcmdx {

struct EventToWrite {
  std::int64_t time = 0;      // [ns] since 1970-01-01 UTC, of where it begins
  std::int64_t duration = 0;  // [ns]; 0: at that time exactly
  std::string channel;        // name of one of EventsToWrite::channels; empty: none
  std::string kind;           // DefectName: "squat"
  std::string severity;       // Classification: "moderate"
  std::string details;        // for people
  // Name and value, the first three go into Parameter1 to Parameter3: {"length [mm]", "32"}
  std::vector<std::pair<std::string, std::string>> parameters;
  double peak = std::numeric_limits<double>::quiet_NaN();  // in the channel's unit
  Place place;
  double latitude = std::numeric_limits<double>::quiet_NaN();  // [deg]
  double longitude = std::numeric_limits<double>::quiet_NaN();
  std::string id;  // UUID; empty: made from the event, the same each time
};

struct ChannelToWrite {
  std::string name, unit;
  std::string basis = "TOTAL";  // ChannelBasis
  std::string neighbour;        // name of the channel on the other rail
  double positionOffset = 0;    // [m]
};

struct TrackToWrite {
  std::int32_t id = 0;
  std::string name, line;  // line: its number
  double length = 0;       // [m]; 0: not known
};
struct LineToWrite {
  std::int32_t id = 0;
  std::string name;
};

struct EventsToWrite {
  std::string platform = "UNKNOWN", vehicleNumber = "-";
  std::string system = "SQUATS";    // measuring system that the events are those of
  std::int64_t start = 0, end = 0;  // [ns] of the session; 0: of the first and last event
  std::string alias;                // of the session: the record that was searched; empty: none
  std::vector<ChannelToWrite> channels;
  std::vector<EventToWrite> events;                 // in any order
  std::vector<std::pair<std::int64_t, Place>> way;  // more positions of the session, [ns]; may be empty
  std::vector<TrackToWrite> tracks;                 // of the topology
  std::vector<LineToWrite> lines;
  // What the processing log says.
  std::string program, host, user;
  std::int64_t written = 0;  // [ns]; 0: the session's end
  // What a reviewer may choose among.
  std::vector<std::string> kinds, severities, verdicts;
};

// A new file, durable (core/DurableFile.h), verified by reading. Mandatory datasets for which there is nothing to say
// are there and empty. Names of groups keep letters, digits and "_-."; others become "_". Throws FileError; CaseError
// for an event of a channel that is not listed.
void writeRcmDx(const std::string& path, const EventsToWrite& events);

// "20190212_231255.592", UTC.
std::string sessionName(std::int64_t time);

// The event as the XML of the specification's schema Events Defect.
std::string defectXml(const EventToWrite& event, const EventsToWrite& all);

}  // namespace squat::rcmdx
