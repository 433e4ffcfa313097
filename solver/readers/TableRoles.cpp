#include "readers/TableRoles.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/Errors.h"
#include "readers/ColumnRoles.h"
#include "text/Heading.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::readers {
namespace {

// Column by name, by its heading as it stands in the file, or by its number from 1.
std::size_t findColumn(const text::DelimitedTable& table, const std::string& wanted) {
  if (const std::size_t c = columnNamed(table, wanted); c != noColumn) return c;
  if (const auto heading = text::headingOf(wanted); !heading.unit.empty())
    if (const std::size_t c = columnNamed(table, heading.name); c != noColumn) return c;
  const std::string lower = text::lowerCase(text::trimmed(wanted));
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(lower.data(), lower.data() + lower.size(), number);
  if (error == std::errc() && end == lower.data() + lower.size() && number >= 1 && number <= table.columns.size())
    return number - 1;
  throw FileError(table.path, "", "has no column '" + wanted + "'", "Its columns are " + columnList(table));
}

bool risesEvenly(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  const double step = values[1] - values[0];
  for (std::size_t i = 1; i < std::min<std::size_t>(values.size(), 100); ++i)
    if (!(std::abs(values[i] - values[i - 1] - step) <= 0.01 * step)) return false;
  return step > 0;
}

// Coordinates of a train drift by metres within the first rows; a lateral acceleration that is called "lat" swings.
bool swings(const std::vector<double>& values) {
  constexpr double farthest = 1e-3;  // [deg] some 100 m
  std::size_t turns = 0;
  double before = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[i - 1];
    if (!std::isfinite(change)) continue;
    low = std::min(low, values[i]), high = std::max(high, values[i]);
    if (change * before < 0) ++turns;
    if (change != 0) before = change;
  }
  return high - low > farthest && 10 * turns > values.size();
}

// The column of dates or times of day that is the time: the one that changes most often, where no column of numbers is
// called a time.
std::size_t momentsForTime(const text::DelimitedTable& table) {
  std::size_t best = noColumn, most = 0;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto& column = table.columns[c];
    if (!column.moments && readers::roleOf(column.name, column.unit) == Role::time) return noColumn;
    if (!column.moments || column.moments == text::MomentKind::date) continue;
    std::size_t changes = 1;
    for (std::size_t i = 1; i < std::min<std::size_t>(column.values.size(), 200); ++i)
      changes += column.values[i] != column.values[i - 1];
    if (changes > most) most = changes, best = c;
  }
  return best;
}

// The axes of a table: role and column of each.
std::vector<std::pair<Role, std::size_t*>> axesOf(TableRoles& roles) {
  return {{Role::time, &roles.time}, {Role::position, &roles.position}, {Role::speed, &roles.speed},
          {Role::run, &roles.run},   {Role::latitude, &roles.latitude}, {Role::longitude, &roles.longitude}};
}

// An axis in a unit that nobody knows would pass for SI.
void requireKnownUnits(const text::DelimitedTable& table, TableRoles& roles) {
  for (const auto& [role, column] : axesOf(roles))
    if (role != Role::run && *column != noColumn && !isUnitOf(table.columns[*column].unit, role))
      throw FileError(
          table.path, "column " + std::to_string(*column + 1),
          "'" + table.columns[*column].name + "' is in " + table.columns[*column].unit + ", which is not known there",
          role == Role::time       ? "Times are in s, ms, us, ns or min; --time-unit UNIT says which"
          : role == Role::position ? "Positions are in m, km, cm, mm, km+m, mile or ft; --unit COLUMN=UNIT says which"
          : role == Role::speed    ? "Speeds are in m/s, km/h, mph or knots; --unit COLUMN=UNIT says which"
                                   : "Coordinates are in degrees");
}

}  // namespace

std::string columnList(const text::DelimitedTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto& name = table.columns[c].name;
    text += (c ? ", " : "") + std::to_string(c + 1) + (name.empty() ? "" : " " + name);
    if (c == 15 && table.columns.size() > 17) return text + ", ...";
  }
  return text;
}

// Case counts only where names differ in nothing else. Two columns of one name are no choice that could be guessed.
std::size_t columnNamed(const text::DelimitedTable& table, const std::string& wanted) {
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
  return found.empty() ? noColumn : found.front();
}

void setUnits(text::DelimitedTable& table, const SignalFileOptions& options) {
  for (const auto& [column, unit] : options.units) table.columns[findColumn(table, column)].unit = unit;
  if (options.timeUnit.empty()) return;
  const auto isTime = [](const text::TableColumn& column) { return roleOf(column.name, column.unit) == Role::time; };
  const auto first = std::find_if(table.columns.begin(), table.columns.end(), isTime);
  std::size_t at = static_cast<std::size_t>(first - table.columns.begin());
  if (!options.timeColumn.empty())
    at = findColumn(table, options.timeColumn);
  else if (first == table.columns.end())
    at = 0;
  table.columns[at].unit = options.timeUnit;
}

TableRoles rolesOf(const text::DelimitedTable& table, const SignalFileOptions& options) {
  TableRoles roles;
  const auto named = [&](const std::string& name) { return name.empty() ? noColumn : findColumn(table, name); };
  roles.time = named(options.timeColumn);
  roles.position = named(options.positionColumn);
  roles.speed = named(options.speedColumn);
  roles.run = named(options.runColumn);
  const auto axes = axesOf(roles);
  const std::size_t bestMoments = momentsForTime(table);
  std::vector<std::size_t> taken;
  for (const auto& [role, column] : axes)
    if (*column != noColumn) taken.push_back(*column);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (std::count(taken.begin(), taken.end(), c) > 0) continue;
    const auto& column = table.columns[c];
    if (column.moments && c != bestMoments) continue;  // the day of the clock in another column, a remark
    const Role own = column.kilometresAndMetres ? Role::position
                     : column.moments           ? Role::time
                                                : roleOf(column.name, column.unit);
    const auto free = std::find_if(axes.begin(), axes.end(),
                                   [&](const auto& axis) { return axis.first == own && *axis.second == noColumn; });
    const bool isCoordinate = own == Role::latitude || own == Role::longitude;
    if (free == axes.end() || (isCoordinate && text::bareUnit(column.unit).empty() && swings(column.values)))
      roles.rest.push_back(c);
    else
      *free->second = c;
  }
  const bool header =
      std::any_of(table.columns.begin(), table.columns.end(), [](const auto& c) { return !c.name.empty(); });
  if (!header && roles.time == noColumn && options.rate == 0 && roles.rest.size() > 1 && roles.rest.front() == 0 &&
      risesEvenly(table.columns[0].values)) {
    roles.time = 0;
    roles.rest.erase(roles.rest.begin());
  }
  requireKnownUnits(table, roles);
  return roles;
}

std::vector<std::size_t> signalsNamed(const text::DelimitedTable& table, const TableRoles& roles,
                                      const SignalFileOptions& options) {
  if (text::lowerCase(options.column) == "all") return roles.rest;
  std::vector<std::size_t> signals;
  if (!options.column.empty())
    for (const auto& name : text::split(options.column, ',')) signals.push_back(findColumn(table, name));
  return signals;
}

}  // namespace squat::readers
