// solver/text/TextTable.h - a table for a terminal: columns as wide as their widest cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::text {

// Columns of a terminal that the longer tables are fitted to.
inline constexpr std::size_t kTerminalWidth = 100;

class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head) : rows_{std::move(head)} {}
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool empty() const { return rows_.size() < 2; }
  // The first row, a line, the rest; every row ends with a line break. `maximumWidth` characters wide (0: as wide as it
  // gets): cells of the widest columns are wrapped between words.
  std::string text(std::size_t maximumWidth = 0) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace squat::text
