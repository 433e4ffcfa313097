// solver/detection/DetectionFiles.h - the list of events as files that other programs read; labels of the user.
#pragma once

#include <string>
#include <vector>

#include "detection/Passes.h"

namespace squat::detection {

struct DetectionReport {
  std::vector<RecordDetection> records;
  std::vector<CombinedEvent> events;
  std::string examples;   // where kinds and severities come from, as text
  SeverityLimits limits;  // of the severities
  std::vector<std::string> notes;
};

// FOLDER/squats.csv, squats.json, squats.geojson where a record has coordinates, and the signal over each squat in
// FOLDER/passages, which `squat estimate` reads (time [s], speed [m/s], acceleration); durable. Passages of an earlier
// call are removed. Returns the paths, the folder of the passages last.
std::vector<std::string> writeDetection(const DetectionReport& report, const std::string& folder);

std::string detectionCsv(const DetectionReport& report);
std::string detectionJson(const DetectionReport& report);
// GeoJSON (RFC 7946): a point an event, longitude first. Empty where no event has coordinates.
std::string detectionGeoJson(const DetectionReport& report);

// The signal over an event, as the files in FOLDER/passages have it.
std::string passageCsv(const Event& event);
// "passages/squat-0007.csv" of the event in row 7 of the table; of what is no squat "other-events/joint-0007.csv",
// which writeDetection() does not write.
std::string passageName(const CombinedEvent& event, std::size_t index);

// What the user has seen, as readLabels() reads it: position, channel, kind, severity of squats.
struct SeenEvent {
  double position = 0;  // [m]
  std::string channel;
  Kind kind = Kind::squat;
  Severity severity = Severity::light;  // of a squat
};
std::string labelsCsv(const std::vector<SeenEvent>& seen);

// position [m] and kind, optionally channel, severity, length [mm], depth [mm] as measured on site; squats.csv as
// corrected by hand will do, whose lengths and depths are estimates and not read. Throws FileError with the line.
std::vector<Label> readLabels(const std::string& path);

}  // namespace squat::detection
