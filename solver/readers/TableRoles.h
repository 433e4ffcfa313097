// solver/readers/TableRoles.h - which column of a table is what: the axes by name, header or unit, and the signals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "text/DelimitedTable.h"

namespace squat::readers {

inline constexpr std::size_t noColumn = static_cast<std::size_t>(-1);

struct TableRoles {
  std::size_t time = noColumn, position = noColumn, speed = noColumn, run = noColumn;
  std::size_t latitude = noColumn, longitude = noColumn;
  std::vector<std::size_t> rest;  // what is no axis
};

// "1 time, 2 aba, ...", for messages.
std::string columnList(const text::DelimitedTable& table);

// Column of that name, case ignored; noColumn: there is none. FileError where two bear it.
std::size_t columnNamed(const text::DelimitedTable& table, const std::string& wanted);

// Units that the call states take the place of those of the table (options.units, options.timeUnit: of the time column,
// the first one where none is known as time). Throws FileError where there is no such column.
void setUnits(text::DelimitedTable& table, const SignalFileOptions& options);

// The axes as the options name them, else as their headers say. A few rows are enough. Throws FileError where a named
// column is missing and where an axis is in an unknown unit.
TableRoles rolesOf(const text::DelimitedTable& table, const SignalFileOptions& options);

// The columns that `options.column` names, "all" for those that are no axis; empty where it names none.
std::vector<std::size_t> signalsNamed(const text::DelimitedTable& table, const TableRoles& roles,
                                      const SignalFileOptions& options);

}  // namespace squat::readers
