#include "readers/SignalFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "core/Errors.h"
#include "readers/ArrayFile.h"
#include "readers/ArraySignals.h"
#include "readers/ColumnRoles.h"
#include "readers/SampledColumns.h"
#include "readers/TableFile.h"
#include "readers/TableRoles.h"
#include "signals/SignalCatalogue.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::readers {
namespace {

// The columns named, else the one named aba, else the only one that is no axis.
std::vector<std::size_t> signalsIn(const text::DelimitedTable& table, const TableRoles& roles,
                                   const SignalFileOptions& options) {
  auto signals = signalsNamed(table, roles, options);
  if (!options.column.empty()) return signals;
  if (roles.rest.size() == 1) return {roles.rest.front()};
  const std::size_t aba = columnNamed(table, signals::names::axleBox);
  if (std::find(roles.rest.begin(), roles.rest.end(), aba) == roles.rest.end())
    throw FileError(table.path, "",
                    roles.rest.empty() ? "has no column besides its axes" : "has several columns of values",
                    "Name the one to read; its columns are " + columnList(table));
  return {aba};
}

void requireRunNumbers(const text::DelimitedTable& table, const TableRoles& roles) {
  if (roles.run == noColumn) return;
  const auto& column = table.columns[roles.run];
  for (std::size_t i = 0; i < column.values.size(); ++i)
    if (!std::isfinite(column.values[i]))
      throw FileError(table.path, table.rowWord + " " + std::to_string(table.lines[i]),
                      "'" + column.name + "' is not a number here", "The run column must contain numbers");
}

// First rows of the runs, and the end of the last.
std::vector<std::size_t> partRuns(const text::DelimitedTable& table, const TableRoles& roles) {
  std::vector<std::size_t> starts{0};
  const std::size_t n = table.rows();
  const std::vector<double>* run = roles.run == noColumn ? nullptr : &table.columns[roles.run].values;
  const std::vector<double>* time = roles.time == noColumn ? nullptr : &table.columns[roles.time].values;
  for (std::size_t i = 1; i < n; ++i) {
    const bool changed = run && !((*run)[i] == (*run)[i - 1]);
    // Back to where this run began: the next one. Anything else that goes back is a mistake, found later.
    const bool back = time && (*time)[i] < (*time)[i - 1] &&
                      std::abs((*time)[i] - (*time)[starts.back()]) < 0.01 * ((*time)[i - 1] - (*time)[starts.back()]);
    if (changed || back) starts.push_back(i);
  }
  starts.push_back(n);
  return starts;
}

std::vector<double> scaledRows(const text::TableColumn& column, const std::string& unit, Role role, std::size_t from,
                               std::size_t to) {
  const double factor = column.kilometresAndMetres ? 1.0 : scaleOf(unit, column.name, role).factor;
  std::vector<double> values(column.values.begin() + static_cast<std::ptrdiff_t>(from),
                             column.values.begin() + static_cast<std::ptrdiff_t>(to));
  if (factor != 1)
    for (double& value : values) value *= factor;
  return values;
}

std::string runName(const text::DelimitedTable& table, const TableRoles& roles, std::size_t column,
                    std::size_t firstRow, std::size_t index, bool severalRuns) {
  std::string name = table.columns[column].name;
  if (name.empty()) name = "column " + std::to_string(column + 1);
  if (!severalRuns) return name;
  if (roles.run == noColumn) return name + ", run " + std::to_string(index + 1);
  const double value = table.columns[roles.run].values[firstRow];
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  return name + ", run " + (whole ? std::to_string(static_cast<long>(value)) : std::to_string(value));
}

}  // namespace

std::vector<signals::Record> signalsOf(const text::DelimitedTable& table, const SignalFileOptions& options) {
  const TableRoles roles = rolesOf(table, options);
  requireRunNumbers(table, roles);
  const auto starts = partRuns(table, roles);
  std::vector<signals::Record> result;
  for (const std::size_t c : signalsIn(table, roles, options)) {
    const auto& column = table.columns[c];
    if (column.badRow == 0 &&
        std::all_of(column.values.begin(), column.values.end(), [](double v) { return std::isnan(v); }))
      throw FileError(table.path, "column " + std::to_string(c + 1), "contains no numbers, but " + column.badText,
                      "Its columns are " + columnList(table));
    for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
      const std::size_t from = starts[r], to = starts[r + 1];
      SampledColumns run;
      run.file = table.path;
      run.run = runName(table, roles, c, from, r, starts.size() > 2);
      run.name = column.name.empty() ? std::filesystem::path(table.path).stem().string() : column.name;
      const auto stated = text::bareUnit(column.unit);
      const auto& unit =
          (stated.empty() || stated == "-") && !options.signalUnit.empty() ? options.signalUnit : column.unit;
      run.unit = scaleOf(unit, column.name, Role::signal).unit;
      run.signal = scaledRows(column, unit, Role::signal, from, to);
      const auto axis = [&](std::size_t of, Role role) {
        return of == noColumn ? std::vector<double>()
                              : scaledRows(table.columns[of], table.columns[of].unit, role, from, to);
      };
      run.time = axis(roles.time, Role::time);
      run.position = axis(roles.position, Role::position);
      run.speed = axis(roles.speed, Role::speed);
      run.location = [&table, from](std::size_t row) {
        return table.rowWord + " " + std::to_string(table.lines[from + row]);
      };
      result.push_back(toRecord(std::move(run), options));
      result.back().run = runName(table, roles, c, from, r, starts.size() > 2);
    }
  }
  return result;
}

signals::Passage passageWithPositions(const signals::Record& record) {
  if (record.position.empty())
    throw CaseError({{"--speed", "none", "a positive number in m/s",
                      record.file + " has neither a position nor a speed column: give the speed"}});
  return signals::passageOf(record);
}

void requireOptions(const SignalFileOptions& options) {
  std::vector<CaseProblem> problems;
  const auto number = [&](const char* key, double value, const char* unit) {
    if (!(std::isfinite(value) && value >= 0))
      problems.push_back(
          {key, std::to_string(value), std::string("a positive number in ") + unit, "Correct the option"});
  };
  number("--rate", options.rate, "Hz");
  number("--speed", options.speed, "m/s");
  for (const auto& [column, unit] : options.units)
    if (!text::findUnit(text::bareUnit(unit)))
      problems.push_back({"--unit", column + "=" + unit,
                          "COLUMN=UNIT with a unit such as s, ms, m, km, m/s, km/h, m/s2, g", "Correct the unit"});
  if (const auto* unit = text::findUnit(text::bareUnit(options.timeUnit));
      !options.timeUnit.empty() && (!unit || unit->si != "s"))
    problems.push_back({"--time-unit", options.timeUnit, "s, ms, us, ns or min", "Correct the unit"});
  if (options.decimal != 0 && options.decimal != '.' && options.decimal != ',')
    problems.push_back({"--decimal-comma", std::string(1, options.decimal), "point or comma", "Correct the option"});
  if (!problems.empty()) throw CaseError(problems);
}

std::vector<signals::Record> readSignals(const std::string& path, const SignalFileOptions& options) {
  requireOptions(options);
  if (isArrayFile(path)) return readArraySignals(path, options);
  auto file = readTableFile(path, options);
  auto own = options;
  if (own.rate == 0) own.rate = file.rate;
  setUnits(file.table, own);
  auto records = signalsOf(file.table, own);
  for (auto& record : records) record.notes.insert(record.notes.end(), file.notes.begin(), file.notes.end());
  return records;
}

}  // namespace squat::readers
