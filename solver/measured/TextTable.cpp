#include "measured/TextTable.h"

#include <algorithm>
#include <cmath>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "measured/TextNumber.h"

namespace squat::measured {
namespace {

constexpr std::size_t largestFile = std::size_t{4} << 30;
constexpr std::size_t longestLine = std::size_t{1} << 20;
constexpr std::size_t linesForLayout = 200;
constexpr std::size_t mostColumns = 4096;

// Walks through the lines of a text; counts them from 1.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return true;
  }
  std::uint32_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::uint32_t number_ = 0;
};

std::string lineText(std::uint32_t number) { return "line " + std::to_string(number); }

std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return "'" + result + (text.size() > 40 ? "..." : "") + "'";
}

void checkText(std::string_view text, const std::string& path) {
  const std::string_view head = text.substr(0, 65536);
  if (head.substr(0, 2) == "\xFF\xFE" || head.substr(0, 2) == "\xFE\xFF")
    throw FileError(path, "", "is UTF-16 text", "Save it as UTF-8 or plain text");
  if (head.find('\0') != std::string_view::npos)
    throw FileError(path, "", "is not a text file", "Export the signal as CSV or HDF5");
}

}  // namespace

TextTable parseTextTable(std::string_view text, const std::string& path, char delimiter, char decimal) {
  checkText(text, path);
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  std::vector<std::string_view> head;
  std::string_view line;
  for (Lines lines(text); head.size() < linesForLayout && lines.next(line);) {
    if (line.size() > longestLine) throw FileError(path, lineText(lines.number()), "is longer than 1 MB");
    head.push_back(line);
  }
  const TableLayout layout = findLayout(head, delimiter, decimal);
  if (layout.fields == 0 || layout.firstLine >= head.size())
    throw FileError(path, "", "contains no table of numbers in its first " + std::to_string(head.size()) + " lines",
                    "Give a table with one row per sample; name delimiter and decimal sign where they are unusual");
  if (layout.fields > mostColumns)
    throw FileError(path, lineText(static_cast<std::uint32_t>(layout.firstLine + 1)), "has too many columns");

  TextTable table;
  table.path = path;
  table.columns.resize(layout.fields);
  const std::size_t roughRows = text.size() / std::max<std::size_t>(head[layout.firstLine].size() + 1, 1) + 16;
  for (std::size_t c = 0; c < layout.fields; ++c) {
    if (!layout.names.empty()) table.columns[c].name = layout.names[c];
    if (!layout.units.empty()) table.columns[c].unit = layout.units[c];
    table.columns[c].values.reserve(std::min<std::size_t>(roughRows, 1u << 26));
  }
  table.lines.reserve(std::min<std::size_t>(roughRows, 1u << 26));

  std::vector<std::string_view> fields;
  for (Lines lines(text); lines.next(line);) {
    if (lines.number() <= layout.firstLine || isComment(line)) continue;
    if (line.size() > longestLine) throw FileError(path, lineText(lines.number()), "is longer than 1 MB");
    splitRow(line, layout, fields);
    if (fields.size() != layout.fields)
      throw FileError(path, lineText(lines.number()),
                      "has " + std::to_string(fields.size()) + " fields, the table " + std::to_string(layout.fields),
                      "Correct the line, or give the delimiter");
    for (std::size_t c = 0; c < fields.size(); ++c) {
      auto& column = table.columns[c];
      double value = std::nan("");
      if (const auto number = numberIn(fields[c], layout.decimal)) {
        value = *number;
      } else if (const auto metres = kilometresAndMetresIn(fields[c], layout.decimal)) {
        value = *metres;
        column.kilometresAndMetres = true;
      } else if (column.badText.empty()) {
        column.badRow = table.lines.size();
        column.badText =
            isMissing(fields[c]) && trimmed(fields[c]).empty() ? "an empty field" : shown(trimmed(fields[c]));
      }
      column.values.push_back(value);
    }
    table.lines.push_back(lines.number());
  }
  return table;
}

TextTable readTextTable(const std::string& path, char delimiter, char decimal) {
  return parseTextTable(readWholeFile(path, largestFile), path, delimiter, decimal);
}

}  // namespace squat::measured
