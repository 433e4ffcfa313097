// app/commands/DetectInParts.h - squat detect --partition and --collect: many records, shared by several processes.
#pragma once

#include <string>
#include <vector>

#include "core/Monitor.h"
#include "detection/Detect.h"
#include "studies/Partition.h"

namespace squat::commands {

// The part of a call of `detect` that does not know how events are judged.
struct RecordSearch {
  std::vector<std::string> records;
  std::string folder;
  records::RecordOptions read;
  detection::DetectOptions options;
};

// Searches the records of one part and keeps their candidates in FOLDER/candidates; those that are there already are
// not searched again. A record that cannot be read is reported and does not stop the others. Exit code.
int searchPart(const RecordSearch& search, const studies::Partition& part, Monitor& monitor);

// What the parts have found, in the order of the records. Throws FileError that names the records without candidates.
std::vector<detection::RecordDetection> collectRecords(const RecordSearch& search);

}  // namespace squat::commands
