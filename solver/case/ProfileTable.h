// solver/case/ProfileTable.h - which columns of a table are a profile, and their numbers; internal to solver/case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

struct LengthColumn {
  std::string name, unit;      // as the heading has them; the name in small letters
  double factor = 1;           // to m
  std::vector<double> values;  // of the rows that count, in `unit`

  double metres(std::size_t row) const;        // exact to the last digit
  std::string written(std::size_t row) const;  // "12.5 mm"
};

struct ProfileTable {
  std::string origin;  // names the text in messages
  LengthColumn position;
  std::vector<LengthColumn> heights;
  std::vector<double> laterals;      // [m] of each column of heights; 0 of one that stands alone
  bool areDepths = false;            // the one column of heights is called a depth
  std::size_t headLine = 0;          // from 1
  std::vector<std::uint32_t> lines;  // of the rows that count, from 1

  // Throws FileError; `line` from 1, 0: of the whole text.
  [[noreturn]] void fail(std::size_t line, const std::string& what, const std::string& advice) const;
};

// Rules and errors: ProfileFile.h. Of a defect with a filter, rows without all their numbers do not count; otherwise
// the first is an error.
ProfileTable profileTable(std::string_view text, const std::string& origin, const std::optional<Defect>& asked);

}  // namespace squat::cases
