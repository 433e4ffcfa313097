#include "text/DelimitedTable.h"

#include <algorithm>
#include <cmath>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::text {
namespace {

constexpr std::size_t largestFile = std::size_t{4} << 30;
constexpr std::size_t linesForLayout = 200;
constexpr std::size_t maximumColumns = 4096;
constexpr std::size_t maximumReserved = std::size_t{1} << 26;  // rows
constexpr const char* advice = "Export the table as CSV or HDF5";

// The rows to come are taken to be as long as the first.
void reserveRows(DelimitedTable& table, std::size_t bytes, std::string_view firstRow) {
  const std::size_t rows = std::min(bytes / (firstRow.size() + 1) + 16, maximumReserved);
  for (auto& column : table.columns) column.values.reserve(rows);
  table.lines.reserve(rows);
}

void addField(TableColumn& column, std::string_view field, char decimal, std::size_t row) {
  const double value = fieldValue(field, decimal, column);
  if (std::isnan(value) && column.badText.empty()) {
    column.badRow = row;
    column.badText = trimmed(field).empty() ? "an empty field" : shown(trimmed(field));
  }
  column.values.push_back(value);
}

}  // namespace

namespace {

double momentValue(std::string_view field, TableColumn& column) {
  constexpr double day = 86400;
  const auto moment = momentIn(field);
  if (!moment || moment->kind != *column.moments) return std::nan("");
  if (moment->kind != MomentKind::clock) return moment->seconds;
  if (moment->seconds < column.clockBefore - day / 2) column.clockDays += day;
  column.clockBefore = moment->seconds;
  return moment->seconds + column.clockDays;
}

}  // namespace

double fieldValue(std::string_view field, char decimal, TableColumn& column) {
  if (column.moments) return momentValue(field, column);
  if (const auto number = numberIn(field, decimal)) return *number;
  if (const auto metres = kilometresAndMetresIn(field, decimal)) {
    column.kilometresAndMetres = true;
    return *metres;
  }
  return std::nan("");
}

TableLayout layoutOf(std::string_view text, const std::string& path, char delimiter, char decimal,
                     std::size_t headLine) {
  std::vector<std::string_view> head;
  std::string_view line;
  for (Lines lines(text, path, advice); head.size() < headLine + linesForLayout && lines.next(line);)
    head.push_back(line);
  TableLayout layout = findLayout(head, delimiter, decimal, headLine);
  if (layout.fields == 0 || layout.firstLine >= head.size())
    throw FileError(path, "", "contains no table of numbers in its first " + std::to_string(head.size()) + " lines",
                    "Give a table with one row per sample; name delimiter and decimal sign where they are unusual");
  if (headLine > 0 && layout.names.empty())
    throw FileError(path, "line " + std::to_string(headLine),
                    "is no heading of the " + std::to_string(layout.fields) + " columns of the table",
                    "Name the line that has as many fields as the rows");
  if (layout.fields > maximumColumns)
    throw FileError(path, "line " + std::to_string(layout.firstLine + 1), "has too many columns");
  return layout;
}

DelimitedTable emptyTable(const TableLayout& layout, const std::string& path) {
  DelimitedTable table;
  table.path = path;
  table.columns.resize(layout.fields);
  for (std::size_t c = 0; c < layout.fields; ++c) {
    if (!layout.names.empty()) table.columns[c].name = layout.names[c];
    if (!layout.units.empty()) table.columns[c].unit = layout.units[c];
    table.columns[c].moments = layout.moments[c];
    if (layout.moments[c]) table.columns[c].unit = "s";
  }
  return table;
}

DelimitedTable parseDelimitedTable(std::string_view text, const std::string& path, char delimiter, char decimal,
                                   std::size_t headLine) {
  const TableLayout layout = layoutOf(text, path, delimiter, decimal, headLine);
  std::string_view line;
  Lines lines(text, path, advice);
  while (lines.number() < layout.firstLine && lines.next(line)) continue;
  auto table = emptyTable(layout, path);
  std::vector<std::string_view> fields;
  while (lines.nextRow(line)) {
    if (table.lines.empty()) reserveRows(table, text.size(), line);
    splitRow(line, layout, fields);
    if (fields.size() != layout.fields)
      throw FileError(path, lines.location(),
                      "has " + std::to_string(fields.size()) + " fields, the table " + std::to_string(layout.fields),
                      "Correct the line, or give the delimiter");
    for (std::size_t c = 0; c < fields.size(); ++c)
      addField(table.columns[c], fields[c], layout.decimal, table.lines.size());
    table.lines.push_back(lines.number());
  }
  return table;
}

DelimitedTable readDelimitedTable(const std::string& path, char delimiter, char decimal, std::size_t headLine) {
  return parseDelimitedTable(readWholeFile(path, largestFile), path, delimiter, decimal, headLine);
}

}  // namespace squat::text
