#include "readers/SignalFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "core/Errors.h"
#include "readers/ColumnRoles.h"
#include "readers/Hdf5Signals.h"
#include "readers/SampledColumns.h"
#include "text/DelimitedTable.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::readers {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

std::string listOf(const text::DelimitedTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto& name = table.columns[c].name;
    text += (c ? ", " : "") + std::to_string(c + 1) + (name.empty() ? "" : " " + name);
    if (c == 15 && table.columns.size() > 17) return text + ", ...";
  }
  return text;
}

// Case counts only where names differ in nothing else. Two columns of one name are no choice that could be guessed.
std::size_t oneNamed(const text::DelimitedTable& table, const std::string& wanted) {
  const std::string name(text::trimmed(wanted)), lower = text::lowerCase(name);
  std::vector<std::size_t> found, exact;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto& own = table.columns[c].name;
    if (!own.empty() && text::lowerCase(own) == lower) found.push_back(c);
    if (!own.empty() && own == name) exact.push_back(c);
  }
  if (exact.size() == 1) return exact.front();
  if (found.size() > 1)
    throw FileError(table.path, "",
                    "has " + std::to_string(found.size()) + " columns '" + name + "': " + std::to_string(found[0] + 1) +
                        " and " + std::to_string(found[1] + 1),
                    "Name the one to read by its number");
  return found.empty() ? none : found.front();
}

std::size_t findColumn(const text::DelimitedTable& table, const std::string& wanted) {
  if (const std::size_t c = oneNamed(table, wanted); c != none) return c;
  const std::string lower = text::lowerCase(text::trimmed(wanted));
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(lower.data(), lower.data() + lower.size(), number);
  if (error == std::errc() && end == lower.data() + lower.size() && number >= 1 && number <= table.columns.size())
    return number - 1;
  throw FileError(table.path, "", "has no column '" + wanted + "'", "Its columns are " + listOf(table));
}

bool risesEvenly(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  const double step = values[1] - values[0];
  for (std::size_t i = 1; i < std::min<std::size_t>(values.size(), 100); ++i)
    if (!(std::abs(values[i] - values[i - 1] - step) <= 0.01 * step)) return false;
  return step > 0;
}

struct Roles {
  std::size_t time = none, position = none, speed = none, run = none;
  std::vector<std::size_t> signals;
};

Roles rolesOf(const text::DelimitedTable& table, const SignalFileOptions& options) {
  Roles roles;
  const auto named = [&](const std::string& name) { return name.empty() ? none : findColumn(table, name); };
  roles.time = named(options.timeColumn);
  roles.position = named(options.positionColumn);
  roles.speed = named(options.speedColumn);
  roles.run = named(options.runColumn);
  const auto taken = [&](std::size_t c) {
    return c == roles.time || c == roles.position || c == roles.speed || c == roles.run;
  };
  std::vector<std::size_t> rest;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (taken(c)) continue;
    const auto& column = table.columns[c];
    Role role = roleOf(column.name, column.unit);
    if (column.kilometresAndMetres) role = Role::position;
    if (role == Role::time && roles.time == none)
      roles.time = c;
    else if (role == Role::position && roles.position == none)
      roles.position = c;
    else if (role == Role::speed && roles.speed == none)
      roles.speed = c;
    else if (role == Role::run && roles.run == none)
      roles.run = c;
    else
      rest.push_back(c);
  }
  const bool header =
      std::any_of(table.columns.begin(), table.columns.end(), [](const auto& c) { return !c.name.empty(); });
  if (!header && roles.time == none && options.rate == 0 && !rest.empty() && rest.front() == 0 && rest.size() > 1 &&
      risesEvenly(table.columns[0].values)) {
    roles.time = 0;
    rest.erase(rest.begin());
  }
  if (text::lowerCase(options.column) == "all") {
    roles.signals = rest;
  } else if (!options.column.empty()) {
    for (std::size_t from = 0; from <= options.column.size();) {
      const std::size_t end = std::min(options.column.find(',', from), options.column.size());
      roles.signals.push_back(findColumn(table, options.column.substr(from, end - from)));
      from = end + 1;
    }
  } else if (rest.size() == 1) {
    roles.signals = rest;
  } else {
    const std::size_t aba = oneNamed(table, "aba");
    if (std::find(rest.begin(), rest.end(), aba) != rest.end()) roles.signals = {aba};
    if (roles.signals.empty())
      throw FileError(table.path, "", rest.empty() ? "has no column besides its axes" : "has several columns of values",
                      "Name the one to read; its columns are " + listOf(table));
  }
  return roles;
}

// An axis in a unit that nobody knows would pass for SI.
void requireKnownUnits(const text::DelimitedTable& table, const Roles& roles) {
  for (const auto& [c, role] : {std::pair{roles.time, Role::time}, std::pair{roles.position, Role::position},
                                std::pair{roles.speed, Role::speed}})
    if (c != none && !isUnitOf(table.columns[c].unit, role))
      throw FileError(table.path, "column " + std::to_string(c + 1),
                      "'" + table.columns[c].name + "' is in " + table.columns[c].unit + ", which is not known there",
                      role == Role::time       ? "Times are in s, ms or us"
                      : role == Role::position ? "Positions are in m, km, cm, mm or km+m"
                                               : "Speeds are in m/s or km/h");
}

void requireRunNumbers(const text::DelimitedTable& table, const Roles& roles) {
  if (roles.run == none) return;
  const auto& column = table.columns[roles.run];
  for (std::size_t i = 0; i < column.values.size(); ++i)
    if (!std::isfinite(column.values[i]))
      throw FileError(table.path, table.rowWord + " " + std::to_string(table.lines[i]),
                      "'" + column.name + "' is not a number here", "The run column must contain numbers");
}

// First rows of the runs, and the end of the last.
std::vector<std::size_t> partRuns(const text::DelimitedTable& table, const Roles& roles) {
  std::vector<std::size_t> starts{0};
  const std::size_t n = table.rows();
  const std::vector<double>* run = roles.run == none ? nullptr : &table.columns[roles.run].values;
  const std::vector<double>* time = roles.time == none ? nullptr : &table.columns[roles.time].values;
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

std::vector<double> scaledRows(const text::TableColumn& column, Role role, std::size_t from, std::size_t to) {
  const double factor = column.kilometresAndMetres ? 1.0 : scaleOf(column.unit, column.name, role).factor;
  std::vector<double> values(column.values.begin() + static_cast<std::ptrdiff_t>(from),
                             column.values.begin() + static_cast<std::ptrdiff_t>(to));
  if (factor != 1)
    for (double& value : values) value *= factor;
  return values;
}

std::string runName(const text::DelimitedTable& table, const Roles& roles, std::size_t column, std::size_t firstRow,
                    std::size_t index, bool severalRuns) {
  std::string name = table.columns[column].name;
  if (name.empty()) name = "column " + std::to_string(column + 1);
  if (!severalRuns) return name;
  if (roles.run == none) return name + ", run " + std::to_string(index + 1);
  const double value = table.columns[roles.run].values[firstRow];
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  return name + ", run " + (whole ? std::to_string(static_cast<long>(value)) : std::to_string(value));
}

// The HDF5 signature stands at the beginning, or behind a user block of 512, 1024, ... bytes (MATLAB writes one).
bool isHdf5(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // a named pipe must not hold the program
  std::ifstream in(path, std::ios::binary);
  for (std::streamoff offset = 0; in && offset <= 65536; offset = offset ? offset * 2 : 512) {
    char head[8] = {};
    in.seekg(offset);
    in.read(head, 8);
    if (in.gcount() == 8 && std::string_view(head, 8) == "\x89HDF\r\n\x1a\n") return true;
  }
  return false;
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
  if (options.decimal != 0 && options.decimal != '.' && options.decimal != ',')
    problems.push_back({"--decimal-comma", std::string(1, options.decimal), "point or comma", "Correct the option"});
  if (!problems.empty()) throw CaseError(problems);
}

}  // namespace

std::vector<signals::Record> signalsOf(const text::DelimitedTable& table, const SignalFileOptions& options) {
  const Roles roles = rolesOf(table, options);
  requireKnownUnits(table, roles);
  requireRunNumbers(table, roles);
  const auto starts = partRuns(table, roles);
  std::vector<signals::Record> result;
  for (const std::size_t c : roles.signals) {
    const auto& column = table.columns[c];
    if (column.badRow == 0 &&
        std::all_of(column.values.begin(), column.values.end(), [](double v) { return std::isnan(v); }))
      throw FileError(table.path, "column " + std::to_string(c + 1), "contains no numbers, but " + column.badText,
                      "Its columns are " + listOf(table));
    for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
      const std::size_t from = starts[r], to = starts[r + 1];
      SampledColumns run;
      run.file = table.path;
      run.run = runName(table, roles, c, from, r, starts.size() > 2);
      run.name = column.name.empty() ? std::filesystem::path(table.path).stem().string() : column.name;
      run.unit = scaleOf(column.unit, column.name, Role::signal).unit;
      run.signal = scaledRows(column, Role::signal, from, to);
      if (roles.time != none) run.time = scaledRows(table.columns[roles.time], Role::time, from, to);
      if (roles.position != none) run.position = scaledRows(table.columns[roles.position], Role::position, from, to);
      if (roles.speed != none) run.speed = scaledRows(table.columns[roles.speed], Role::speed, from, to);
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

std::vector<signals::Record> readSignals(const std::string& path, const SignalFileOptions& options) {
  requireOptions(options);
  if (isHdf5(path)) return readHdf5Signals(path, options);
  return signalsOf(text::readDelimitedTable(path, options.delimiter, options.decimal), options);
}

}  // namespace squat::readers
