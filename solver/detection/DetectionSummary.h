// solver/detection/DetectionSummary.h - found events as text, for a terminal and for the studio.
#pragma once

#include <string>

#include "detection/DetectionFiles.h"

namespace squat::detection {

// Faults of a record with place and advice, the first twenty, and its notes: a line each. Empty: none.
std::string faultText(const RecordDetection& record);

// A line for each record, then the table of events.
std::string detectionSummary(const DetectionReport& report);

}  // namespace squat::detection
