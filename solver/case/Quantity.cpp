#include "case/Quantity.h"

#include <array>
#include <numbers>

#include "case/DecimalNumber.h"

namespace squat::cases {

namespace {

// SI value = number * 10^power / divisor. Units with the same SI unit measure the same quantity.
struct UnitRow {
  std::string_view name, si;
  int power = 0;
  double divisor = 1;
};

constexpr double perMinute = 30 / std::numbers::pi;  // revolutions per minute in a rad/s

constexpr std::array units{
    UnitRow{"m", "m", 0},
    UnitRow{"km", "m", 3},
    UnitRow{"cm", "m", -2},
    UnitRow{"mm", "m", -3},
    UnitRow{"um", "m", -6},
    UnitRow{"\u00B5m", "m", -6},
    UnitRow{"\u03BCm", "m", -6},
    UnitRow{"kg", "kg", 0},
    UnitRow{"t", "kg", 3},
    UnitRow{"g", "kg", -3},
    UnitRow{"kg/m3", "kg/m3", 0},
    UnitRow{"kg/m\u00B3", "kg/m3", 0},
    UnitRow{"t/m3", "kg/m3", 3},
    UnitRow{"g/cm3", "kg/m3", 3},
    UnitRow{"Pa", "Pa", 0},
    UnitRow{"kPa", "Pa", 3},
    UnitRow{"MPa", "Pa", 6},
    UnitRow{"N/mm2", "Pa", 6},
    UnitRow{"N/mm\u00B2", "Pa", 6},
    UnitRow{"GPa", "Pa", 9},
    UnitRow{"N", "N", 0},
    UnitRow{"kN", "N", 3},
    UnitRow{"N/m", "N/m", 0},
    UnitRow{"kN/m", "N/m", 3},
    UnitRow{"N/mm", "N/m", 3},
    UnitRow{"MN/m", "N/m", 6},
    UnitRow{"kN/mm", "N/m", 6},
    UnitRow{"N s/m", "N s/m", 0},
    UnitRow{"Ns/m", "N s/m", 0},
    UnitRow{"kN s/m", "N s/m", 3},
    UnitRow{"kNs/m", "N s/m", 3},
    UnitRow{"m/s", "m/s", 0},
    UnitRow{"km/h", "m/s", 0, 3.6},
    UnitRow{"rad/s", "rad/s", 0},
    UnitRow{"rpm", "rad/s", 0, perMinute},
    UnitRow{"N m", "N m", 0},
    UnitRow{"Nm", "N m", 0},
    UnitRow{"kN m", "N m", 3},
    UnitRow{"kNm", "N m", 3},
    UnitRow{"s", "s", 0},
    UnitRow{"ms", "s", -3},
    UnitRow{"us", "s", -6},
    UnitRow{"\u00B5s", "s", -6},
    UnitRow{"\u03BCs", "s", -6},
    UnitRow{"m/s2", "m/s2", 0},
    UnitRow{"m/s\u00B2", "m/s2", 0},
    UnitRow{"dB", "dB", 0},
    UnitRow{"Hz", "Hz", 0},
    UnitRow{"kHz", "Hz", 3},
    UnitRow{"-", "-", 0},
    UnitRow{"%", "-", -2},
};

std::string_view siUnitOf(const Parameter& parameter) {
  if (parameter.integer) return {};  // counts
  for (const auto& unit : units)
    if (unit.name == parameter.unit) return unit.si;
  return {};
}

}  // namespace

std::optional<double> parseQuantity(std::string_view text, const Parameter& parameter) {
  if (const auto plain = parseDecimal(text, parameter.powerOfTen)) return plain;
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  const auto si = siUnitOf(parameter);
  for (const auto& unit : units) {
    if (unit.si != si || unit.name == "-" || !text.ends_with(unit.name)) continue;
    if (const auto value = parseDecimal(text.substr(0, text.size() - unit.name.size()), unit.power))
      return *value / unit.divisor;
  }
  return std::nullopt;
}

std::string knownUnits(const Parameter& parameter) {
  const auto si = siUnitOf(parameter);
  std::string names;
  for (const auto& unit : units)
    if (unit.si == si && unit.name != "-") names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

}  // namespace squat::cases
