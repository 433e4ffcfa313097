// solver/records/ChosenColumns.h - which columns of a file a record is made of, and their factors to SI units.
#pragma once

#include <string>
#include <vector>

#include "records/RecordStream.h"
#include "records/RowSource.h"

namespace squat::records {

struct ChosenColumn {
  std::size_t column = 0;  // of the table
  double factor = 1;       // to SI
  std::string name, unit;  // unit: SI
  bool unitStated = true;  // by the file or the call
};

struct ChosenColumns {
  std::vector<ChosenColumn> channels;
  // One or none of each.
  std::vector<ChosenColumn> time, position, speed, run, latitude, longitude;
  std::vector<std::string> notes;
};

// Channels as `options.column` names them; without it the column aba, else every column that is no axis and whose unit
// is an acceleration or none. Throws FileError where there is none, and for one whose unit is not stated or no
// acceleration.
// `everyAcceleration`: a column aba is not preferred. Counters, gyroscopes, temperatures and the like are passed over.
ChosenColumns chooseColumns(const text::DelimitedTable& head, const readers::SignalFileOptions& options,
                            bool everyAcceleration = false);

}  // namespace squat::records
