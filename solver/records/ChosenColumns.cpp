#include "records/ChosenColumns.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/Errors.h"
#include "readers/ColumnRoles.h"
#include "readers/TableRoles.h"
#include "signals/SignalCatalogue.h"
#include "text/Heading.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::records {
namespace {

using readers::Role;

bool hasNumbers(const text::TableColumn& column) {
  return std::any_of(column.values.begin(), column.values.end(), [](double value) { return std::isfinite(value); });
}

ChosenColumn chosen(const text::DelimitedTable& head, std::size_t index, Role role, const std::string& otherwise) {
  const auto& column = head.columns[index];
  const auto stated = text::bareUnit(column.unit);
  const auto& unit = stated.empty() || stated == "-" ? otherwise : column.unit;
  const auto scale = readers::scaleOf(unit, column.name, role);
  ChosenColumn result{index, column.kilometresAndMetres ? 1.0 : scale.factor, column.name, scale.unit,
                      !text::bareUnit(unit).empty()};
  if (result.name.empty())
    result.name = head.columns.size() > 1 ? "column " + std::to_string(index + 1)
                                          : std::filesystem::path(head.path).stem().string();
  if (role != Role::signal) return result;
  const std::string bare = text::bareUnit(unit);
  if (result.unit == "m/s2") return result;
  const auto place = "column " + std::to_string(index + 1);
  if (!result.unitStated || bare == "-")
    throw FileError(head.path, place, "'" + result.name + "' states no unit",
                    "Give it, --unit m/s2, say, or --unit g, in the studio under Units; or name the columns to read");
  throw FileError(head.path, place, "'" + result.name + "' is in " + bare + ", which is no acceleration",
                  "Choose another column, or give its unit: --unit \"" + result.name + "=g\", say");
}

// Rows or seconds that are counted: it rises by the same amount again and again.
bool isCounter(const text::TableColumn& column) {
  const auto& values = column.values;
  if (values.size() < 16) return false;
  for (std::size_t i = 2; i < values.size(); ++i) {
    const double first = values[1] - values[0], step = values[i] - values[i - 1];
    if (!(first > 0) || !(std::abs(step - first) <= 1e-3 * first)) return false;
  }
  return true;
}

bool namesAnotherQuantity(const text::TableColumn& column) {
  const std::string name = text::lowerCase(column.name);
  for (const char* word : {"count", "index", "sample", "status", "gyro", "temp", "humid", "volt", "battery"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

// Whether an axle box acceleration could be in this column: its unit is one, or none is stated and its numbers are no
// counter's.
bool mayBeAcceleration(const text::TableColumn& column) {
  const std::string bare = text::bareUnit(column.unit);
  if (!hasNumbers(column)) return false;
  if (bare.empty() || bare == "-") return !isCounter(column) && !namesAnotherQuantity(column);
  return readers::scaleOf(bare, "", Role::signal).unit == "m/s2";
}

std::vector<std::size_t> channelsOf(const text::DelimitedTable& head, const readers::TableRoles& roles,
                                    const readers::SignalFileOptions& options, bool everyAcceleration,
                                    std::vector<std::string>& notes) {
  auto channels = readers::signalsNamed(head, roles, options);
  if (!channels.empty()) return channels;
  if (roles.rest.size() == 1) return {roles.rest.front()};
  if (!everyAcceleration)
    if (const auto aba = readers::columnNamed(head, signals::names::axleBox); aba != readers::noColumn) return {aba};
  const auto isStated = [&](std::size_t c) {
    return readers::scaleOf(head.columns[c].unit, "", Role::signal).unit == "m/s2";
  };
  const bool anyStated = std::any_of(roles.rest.begin(), roles.rest.end(), isStated);
  // Beside accelerations that state their unit, a column without one is a trigger or the like, unless its name says
  // more.
  const auto isMeant = [&](std::size_t c) {
    return isStated(c) || !anyStated || !options.signalUnit.empty() ||
           text::siUnitOfName(head.columns[c].name) == "m/s2";
  };
  std::string others;
  for (const std::size_t c : roles.rest)
    if (mayBeAcceleration(head.columns[c]) && isMeant(c))
      channels.push_back(c);
    else
      others += (others.empty() ? "" : ", ") + std::to_string(c + 1) + " " + head.columns[c].name;
  if (!channels.empty() && !others.empty()) notes.push_back("columns passed over, as no accelerations: " + others);
  return channels;
}

}  // namespace

ChosenColumns chooseColumns(const text::DelimitedTable& head, const readers::SignalFileOptions& options,
                            bool everyAcceleration) {
  const auto roles = readers::rolesOf(head, options);
  ChosenColumns result;
  for (const std::size_t c : channelsOf(head, roles, options, everyAcceleration, result.notes))
    result.channels.push_back(chosen(head, c, Role::signal, options.signalUnit));
  if (result.channels.empty())
    throw FileError(head.path, "",
                    roles.rest.empty() ? "has no column besides its axes" : "has no column of accelerations",
                    "Name the ones to read; its columns are " + readers::columnList(head));
  const auto axis = [&](std::size_t index, Role role, std::vector<ChosenColumn>& column) {
    if (index != readers::noColumn) column.push_back(chosen(head, index, role, {}));
  };
  axis(roles.time, Role::time, result.time);
  axis(roles.position, Role::position, result.position);
  axis(roles.speed, Role::speed, result.speed);
  axis(roles.run, Role::run, result.run);
  if (roles.latitude == readers::noColumn || roles.longitude == readers::noColumn) return result;
  axis(roles.latitude, Role::latitude, result.latitude);
  axis(roles.longitude, Role::longitude, result.longitude);
  return result;
}

}  // namespace squat::records
