// app/commands/DetectionSummary.h - found events as a table on the terminal.
#pragma once

#include "detection/DetectionFiles.h"

namespace squat::commands {

// Faults and notes of a record, on stderr; the first twenty.
void printFaults(const detection::RecordDetection& record);

// A line for each record and the table of events, on stdout.
void printEvents(const detection::DetectionReport& report);

}  // namespace squat::commands
