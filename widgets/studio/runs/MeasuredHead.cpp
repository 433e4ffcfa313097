#include "studio/runs/MeasuredHead.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "core/Errors.h"
#include "loggers/LoggerFile.h"
#include "readers/ArrayFile.h"
#include "readers/ArrayItems.h"
#include "readers/ArraySignals.h"
#include "readers/TableFile.h"
#include "signals/SignalCatalogue.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"
#include "text/Utf8Text.h"

namespace squat::studio {
namespace {

constexpr std::size_t headBytes = std::size_t{4} << 20;  // the lines that show the layout, however long they are
constexpr std::size_t valueRows = 100;                   // a column that rises evenly shows it in these
constexpr std::size_t shownRows = 20;

// Whole lines alone.
std::string beginningOf(const std::string& path) {
  std::error_code ignored;
  std::ifstream in;
  if (std::filesystem::is_regular_file(path, ignored)) in.open(path, std::ios::binary);  // a named pipe would wait
  if (!in.is_open()) throw FileError(path, "", "cannot be read", "Check its path and its permissions");
  std::string beginning(headBytes, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(headBytes));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  if (beginning.size() == headBytes) beginning.resize(beginning.rfind('\n') + 1);
  return beginning;
}

void readText(MeasuredHead& head, const readers::SignalFileOptions& options) {
  const std::string beginning = beginningOf(head.path);
  const auto layout = text::layoutOf(beginning, head.path, options.delimiter, options.decimal, options.headLine);
  head.table = text::emptyTable(layout, head.path);
  head.numeric = layout.numeric;
  head.numeric.resize(layout.fields, false);
  text::Lines lines(beginning, head.path, "");
  std::string_view line;
  while (lines.number() < layout.firstLine && lines.next(line)) continue;
  std::vector<std::string_view> fields;
  for (std::size_t row = 0; row < valueRows && lines.nextRow(line); ++row) {
    text::splitRow(line, layout, fields);
    if (row < shownRows) {
      auto& cells = head.rows.emplace_back();
      for (const auto field : fields) cells.push_back(text::asUtf8(text::trimmed(field)));
    }
    if (fields.size() != layout.fields) continue;  // the reader says what is wrong with it
    for (std::size_t c = 0; c < fields.size(); ++c) {
      auto& column = head.table.columns[c];
      column.values.push_back(text::fieldValue(fields[c], layout.decimal, column));
    }
    head.table.lines.push_back(lines.number());
  }
}

// Files of measuring programs, and packed text, are read as the solver will.
void readWhole(MeasuredHead& head, const readers::SignalFileOptions& options) {
  auto file = readers::readTableFile(head.path, options);
  head.rate = file.rate;
  const std::size_t rows = std::min(valueRows, file.table.rows());
  for (auto& column : file.table.columns) column.values.resize(rows);
  file.table.lines.resize(rows);
  for (std::size_t row = 0; row < std::min(shownRows, rows); ++row) {
    auto& cells = head.rows.emplace_back();
    for (const auto& column : file.table.columns) cells.push_back(text::numberText(column.values[row]));
  }
  head.numeric.assign(file.table.columns.size(), true);
  head.table = std::move(file.table);
}

bool isAba(const readers::ArrayItem& item) { return text::lowerCase(item.name) == signals::names::axleBox; }

// Arrays of one or two dimensions; a single number is no signal.
bool isSignal(const readers::ArrayItem& item) {
  return readers::lengthOf(*item.array) > 1 && !readers::isNested(*item.array);
}

std::vector<ArrayPart> partsOf(const std::vector<readers::ArrayItem>& items) {
  std::vector<ArrayPart> parts;
  for (const auto& item : items) {
    if (!isSignal(item)) continue;
    const std::size_t samples = readers::lengthOf(*item.array);
    const auto same = std::find_if(parts.begin(), parts.end(), [&](const auto& part) {
      return part.group == item.group && part.samples == samples;
    });
    if (same == parts.end())
      parts.push_back({item.group, samples, item.path});
    else if (isAba(item))
      same->object = item.path;
  }
  return parts;
}

// Groups with a signal called aba; where there is none, all groups with signals.
std::size_t groupsMeant(const std::vector<readers::ArrayItem>& items) {
  std::set<std::string> all, withAba;
  for (const auto& item : items) {
    if (!isSignal(item)) continue;
    all.insert(item.group);
    if (isAba(item)) withAba.insert(item.group);
  }
  return withAba.empty() ? all.size() : withAba.size();
}

void readArrays(MeasuredHead& head, readers::SignalFileOptions options) {
  const auto tree = readers::listArrays(head.path);
  const auto items = readers::itemsOf(tree);
  head.parts = partsOf(items);
  head.severalParts = options.object.empty() && groupsMeant(items) > 1;
  options.rate = options.speed = 0;
  readers::ArrayColumns found;
  try {
    found = readers::columnsOf(head.path, tree, options);
  } catch (const FileError&) {
    if (head.parts.empty() || !options.object.empty()) throw;
    options.object = head.parts.front().object;
    found = readers::columnsOf(head.path, tree, options);
  }
  head.table = std::move(found.table);
  head.places = std::move(found.places);
  head.samples = found.samples;
  head.rate = found.options.rate, head.speed = found.options.speed;
  head.numeric.assign(head.table.columns.size(), true);
  if (head.places.empty()) return;
  const auto first = std::find_if(items.begin(), items.end(),
                                  [&](const auto& item) { return item.array->path == head.places[0].path; });
  for (std::size_t i = 0; first != items.end() && i < head.parts.size(); ++i)
    if (head.parts[i].group == first->group && head.parts[i].samples == head.samples) head.part = i;
}

bool isOfRun(const MeasuredHead& head, std::size_t column, const std::string& run) {
  std::string name = head.table.columns[column].name;
  if (name.empty()) name = "column " + std::to_string(column + 1);  // as the reader calls it
  return run == name || run.starts_with(name + ", run ");
}

}  // namespace

MeasuredHead headOf(const std::string& path, const readers::SignalFileOptions& options) {
  MeasuredHead head;
  head.path = path;
  try {
    if (readers::isArrayFile(path))
      readArrays(head, options);
    else if (loggers::isLoggerFile(path) || loggers::isPacked(path))
      readWhole(head, options);
    else
      readText(head, options);
  } catch (const std::exception& error) {
    head.problem = error.what();
  }
  return head;
}

std::vector<std::vector<std::string>> firstRows(const MeasuredHead& head) {
  std::vector<std::vector<double>> columns;
  readers::streamArrays(head.path, head.places, head.samples)->next(columns);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t row = 0; row < std::min(head.samples, shownRows); ++row) {
    auto& cells = rows.emplace_back();
    for (const auto& column : columns) cells.push_back(row < column.size() ? text::roundedText(column[row]) : "");
  }
  return rows;
}

readers::TableRoles rolesIn(const MeasuredHead& head, const readers::SignalFileOptions& options) {
  try {
    return readers::rolesOf(head.table, options);
  } catch (const FileError&) {
    return {};
  }
}

std::size_t clearSignal(const MeasuredHead& head, const readers::TableRoles& roles) {
  if (roles.rest.size() == 1) return roles.rest.front();
  try {
    const std::size_t aba = readers::columnNamed(head.table, signals::names::axleBox);
    if (std::find(roles.rest.begin(), roles.rest.end(), aba) != roles.rest.end()) return aba;
  } catch (const FileError&) {
    // Two of that name.
  }
  return readers::noColumn;
}

std::size_t likelySignal(const MeasuredHead& head, const readers::SignalFileOptions& options, const std::string& run) {
  const auto roles = rolesIn(head, options);
  try {
    const auto named = readers::signalsNamed(head.table, roles, options);
    for (const std::size_t column : named)
      if (isOfRun(head, column, run)) return column;
    if (!named.empty()) return named.front();
  } catch (const FileError&) {
    // No longer in the file.
  }
  for (const std::size_t column : roles.rest)
    if (isOfRun(head, column, run)) return column;
  if (const std::size_t clear = clearSignal(head, roles); clear != readers::noColumn) return clear;
  const auto find = [&](bool acceleration) {
    for (const std::size_t column : roles.rest) {
      const auto* unit = text::findUnit(text::bareUnit(head.table.columns[column].unit));
      if (head.numeric[column] && (!acceleration || (unit && unit->si == "m/s2"))) return column;
    }
    return readers::noColumn;
  };
  const std::size_t acceleration = find(true);
  return acceleration != readers::noColumn ? acceleration : find(false);
}

std::string optionOf(const MeasuredHead& head, std::size_t column) {
  const std::string& name = head.table.columns[column].name;
  const std::string lower = text::lowerCase(name);
  const auto same = std::count_if(head.table.columns.begin(), head.table.columns.end(),
                                  [&](const auto& other) { return text::lowerCase(other.name) == lower; });
  const bool plain = !name.empty() && same == 1 && lower != "all" && name.find(',') == std::string::npos &&
                     text::trimmed(name) == name;
  return plain ? name : std::to_string(column + 1);
}

QString columnText(const MeasuredHead& head, std::size_t column) {
  const auto& described = head.table.columns[column];
  QString words = QString::number(column + 1);
  if (!described.name.empty()) words += ": " + QString::fromStdString(described.name);
  if (!described.unit.empty()) words += " [" + QString::fromStdString(text::printedUnit(described.unit)) + "]";
  return words;
}

bool needsChoice(const MeasuredHead& head) {
  if (!head.problem.empty()) return false;  // nothing that could be chosen
  if (head.severalParts) return true;
  const auto roles = rolesIn(head, {});
  return roles.rest.size() > 1 && clearSignal(head, roles) == readers::noColumn;
}

}  // namespace squat::studio
