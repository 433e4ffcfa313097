// solver/loggers/LoggerTable.h - what a measuring program's own file holds, as a table: names, units, rate and numbers.
#pragma once

#include <string>
#include <vector>

#include "text/DelimitedTable.h"

namespace squat::loggers {

// Channels of one rate and one length. Values are as the file means them: its own scales and offsets are applied, its
// units stay (the readers convert them). `table.lines` counts the rows from 1, `table.rowWord` is "sample".
struct LoggerTable {
  text::DelimitedTable table;
  double rate = 0;                 // [Hz] as the file states it; 0: a column of the table is the time
  std::vector<std::string> notes;  // what was left out or assumed, one short sentence each
};

}  // namespace squat::loggers
