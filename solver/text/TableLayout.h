// solver/text/TableLayout.h - how a text table is laid out, found from its first lines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/Moments.h"

namespace squat::text {

struct TableLayout {
  char delimiter = ',';  // ' ' stands for any blanks
  char decimal = '.';
  std::size_t fields = 0;
  std::size_t firstLine = 0;                       // index into the lines of the first row of numbers
  std::size_t headLine = 0;                        // line of the names, from 1; 0: without header
  std::vector<std::string> names;                  // per column, in UTF-8; empty without header
  std::vector<std::string> units;                  // per column; empty texts where none
  std::vector<bool> numeric;                       // columns that held numbers at the end of the lines looked at
  std::vector<std::optional<MomentKind>> moments;  // those that held dates or times of day there
};

// The fields of a row of the table (splitFields): empty fields beyond its last column do not count.
void splitRow(std::string_view line, const TableLayout& layout, std::vector<std::string_view>& fields);

// `lines` are the first lines of the file, whole, without line ends. `delimiter` and `decimal` 0: found. `headLine`:
// the line of the heading, from 1; 0: the last above the numbers that has as many fields. A layout with fields == 0: no
// table was found.
TableLayout findLayout(const std::vector<std::string_view>& lines, char delimiter, char decimal,
                       std::size_t headLine = 0);

}  // namespace squat::text
