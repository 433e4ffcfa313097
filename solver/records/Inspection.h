// solver/records/Inspection.h - how a file is understood, for whoever wants to see it before anything is computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "records/RecordStream.h"

namespace squat::records {

struct InspectedColumn {
  std::string name, unit;     // as the file or the call states them; empty: nothing is stated
  std::string use;            // "time", "position", ..., "signal", "passed over"
  std::vector<double> first;  // a few rows, as they stand in the file
};

struct Inspection {
  std::string path, structure;
  std::vector<InspectedColumn> columns;
  std::string refusal;  // why it cannot be read as a record; empty: it can
  // Of the record; empty where there is none.
  std::optional<RecordLayout> layout;
  std::size_t read = 0;       // samples that are used
  double duration = 0;        // [s]
  std::optional<double> way;  // [m]; none: neither position nor speed is known
  std::vector<RecordFault> faults;
  std::vector<std::string> doubts;  // what was assumed or is odd
  bool cancelled = false;
};

// Reads the whole file. Throws FileError for one that holds no table, CaseError for options that do not fit.
Inspection inspectRecord(const std::string& path, const RecordOptions& options, Monitor& monitor);

}  // namespace squat::records
