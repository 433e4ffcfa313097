#include "receptance/DynamicPads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::receptance {

namespace {

using text::TableColumn;

constexpr double softestPad = 1e6, stiffestPad = 1e11;  // [N/m]

std::optional<double> stiffnessFactor(std::string unit) {
  std::erase(unit, ' ');
  constexpr std::array<std::pair<std::string_view, double>, 6> known{
      {{"n/m", 1}, {"n/mm", 1e3}, {"kn/m", 1e3}, {"kn/mm", 1e6}, {"mn/m", 1e6}, {"n/um", 1e6}}};
  unit = text::lowerCase(unit);
  for (const auto& [name, factor] : known)
    if (unit == name) return factor;
  return std::nullopt;
}

struct StiffnessColumns {
  const TableColumn *real = nullptr, *imaginary = nullptr;
};

StiffnessColumns columnsOf(const text::DelimitedTable& table, bool lateral) {
  StiffnessColumns found;
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    const auto name = text::lowerCase(column.name);
    if (!stiffnessFactor(column.unit) || (name.find("lateral") != std::string::npos) != lateral) continue;
    const bool imaginary = name.find("imag") != std::string::npos;
    if (imaginary && !found.imaginary) found.imaginary = &column;
    if (!imaginary && name.find("real") != std::string::npos && !found.real) found.real = &column;
  }
  return found;
}

std::complex<double> stiffnessAt(const StiffnessColumns& columns, std::size_t row) {
  return {columns.real->values[row] * *stiffnessFactor(columns.real->unit),
          columns.imaginary->values[row] * *stiffnessFactor(columns.imaginary->unit)};
}

void requirePlausible(const std::complex<double>& stiffness, const text::DelimitedTable& table, std::size_t row) {
  const double size = std::abs(stiffness);
  if (size >= softestPad && size <= stiffestPad && stiffness.real() > 0 && stiffness.imag() >= 0) return;
  throw FileError(table.path, table.rowWord + " " + std::to_string(table.lines[row]),
                  "the stiffness is " + text::formatted("%.3g", stiffness.real()) +
                      text::formatted(" + %.3g i N/m", stiffness.imag()),
                  "Pads have 1 MN/m to 100 GN/m and a positive loss: check the unit in the heading and the sign");
}

}  // namespace

std::vector<scenario::DynamicStiffness> readDynamicStiffness(const std::string& path) {
  const auto table = text::readDelimitedTable(path);
  const auto vertical = columnsOf(table, false), lateral = columnsOf(table, true);
  if (!vertical.real || !vertical.imaginary)
    throw FileError(path, "", "has no columns of the real and the imaginary part of a stiffness with a known unit",
                    "Name them, e.g. frequency [Hz], stiffness real [MN/m], stiffness imaginary [MN/m]");
  if (text::lowerCase(table.columns[0].unit) != "hz")
    throw FileError(path, "column '" + table.columns[0].name + "'", "must be the frequency in Hz");
  std::vector<scenario::DynamicStiffness> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    scenario::DynamicStiffness at{table.columns[0].values[row], stiffnessAt(vertical, row), 0};
    if (lateral.real && lateral.imaginary) at.lateral = stiffnessAt(lateral, row);
    if (!(at.frequency > (rows.empty() ? 0 : rows.back().frequency)))
      throw FileError(path, table.rowWord + " " + std::to_string(table.lines[row]), "the frequency does not rise");
    requirePlausible(at.vertical, table, row);
    if (at.lateral != 0.0) requirePlausible(at.lateral, table, row);
    rows.push_back(at);
  }
  if (rows.empty()) throw FileError(path, "", "has no rows");
  return rows;
}

scenario::Scenario withDynamicPads(scenario::Scenario scenario) {
  if (!scenario.pad.dynamicFile.empty()) scenario.pad.dynamic = readDynamicStiffness(scenario.pad.dynamicFile);
  return scenario;
}

}  // namespace squat::receptance
