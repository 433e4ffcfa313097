// solver/text/DelimitedTable.h - a text file as columns of numbers.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/Moments.h"
#include "text/TableLayout.h"

namespace squat::text {

struct TableColumn {
  std::string name, unit;      // empty where the file has none
  std::vector<double> values;  // not-a-number where the field is missing or text
  bool kilometresAndMetres = false;
  std::optional<MomentKind> moments;      // its fields are dates or times of day; `values` are in s
  double clockBefore = 0, clockDays = 0;  // [s] of a clock: the field before; the midnights that have passed
  // First field that is not a number: its row, and what stands there.
  std::size_t badRow = std::numeric_limits<std::size_t>::max();
  std::string badText;
};

struct DelimitedTable {
  std::string path;
  std::vector<TableColumn> columns;
  std::vector<std::uint32_t> lines;  // line of each row in the file, from 1
  std::string rowWord = "line";      // what `lines` counts

  std::size_t rows() const { return lines.size(); }
};

// The number that stands in a field: plain or as kilometres and metres, which is noted in the column; of a column of
// moments, the moment in s; a clock that passes midnight rises on. Not-a-number for any other text.
double fieldValue(std::string_view field, char decimal, TableColumn& column);

// The layout of a table that begins with `text`, and its columns without rows. Throws FileError where there is no
// table.
TableLayout layoutOf(std::string_view text, const std::string& path, char delimiter, char decimal,
                     std::size_t headLine = 0);
DelimitedTable emptyTable(const TableLayout& layout, const std::string& path);

// Throws FileError (path, line) for an unreadable or binary file, one without a table of numbers, and for rows with
// another number of fields than the first.
DelimitedTable readDelimitedTable(const std::string& path, char delimiter = 0, char decimal = 0,
                                  std::size_t headLine = 0);

// The same for text that stands in memory.
DelimitedTable parseDelimitedTable(std::string_view text, const std::string& path, char delimiter = 0, char decimal = 0,
                                   std::size_t headLine = 0);

}  // namespace squat::text
