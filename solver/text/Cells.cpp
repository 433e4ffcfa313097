#include "text/Cells.h"

#include <algorithm>
#include <array>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Csv.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Utf8Text.h"

namespace squat::text {
namespace {

// The sign that parts the heading into most fields; none in quotes counts.
char delimiterOf(std::string_view heading) {
  constexpr std::array<char, 3> signs{',', ';', '\t'};
  const auto fields = [&](char sign) {
    std::vector<std::string_view> parts;
    splitFields(heading, sign, parts);
    return parts.size();
  };
  return *std::max_element(signs.begin(), signs.end(), [&](char a, char b) { return fields(a) < fields(b); });
}

// "0,99" is a number where no cell of the table is one with a point.
bool hasDecimalCommas(const Cells& cells) {
  bool commas = false;
  for (std::size_t r = 1; r < cells.rows.size(); ++r)
    for (const auto& cell : cells.rows[r]) {
      if (cell.find('.') != std::string::npos && numberIn(cell, '.')) return false;
      commas = commas || (cell.find(',') != std::string::npos && numberIn(cell, ','));
    }
  return commas;
}

}  // namespace

Cells cellsOf(std::string_view text, const std::string& path) {
  // A line break inside quotes does not end the row.
  Cells cells;
  Lines lines(text, path, "Save the table as CSV");
  std::string_view line;
  char delimiter = 0;
  while (lines.next(line)) {
    if (isComment(line)) continue;
    if (delimiter == 0) delimiter = delimiterOf(line);
    const auto number = lines.number();
    std::string row(line);
    bool isOpen = std::count(row.begin(), row.end(), '"') % 2 == 1;
    while (isOpen && lines.next(line)) {
      row.append("\n").append(line);
      isOpen = std::count(line.begin(), line.end(), '"') % 2 == 0;
    }
    if (isOpen)
      throw FileError(path, "line " + std::to_string(number), "opens a quote that is not closed",
                      "Remove or double it");
    auto records = csvRecords(row, delimiter);
    if (records.empty()) continue;
    for (auto& cell : records.front()) cell = asUtf8(trimmed(cell));
    cells.rows.push_back(std::move(records.front()));
    cells.lines.push_back(number);
  }
  if (delimiter != ',' && hasDecimalCommas(cells))
    for (std::size_t r = 1; r < cells.rows.size(); ++r)
      for (auto& cell : cells.rows[r])
        if (numberIn(cell, ',')) std::replace(cell.begin(), cell.end(), ',', '.');
  return cells;
}

Cells readCells(const std::string& path, std::size_t largestFile) {
  return cellsOf(readWholeFile(path, largestFile), path);
}

}  // namespace squat::text
