#include "text/Units.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::text {
namespace {

constexpr std::array<Unit, 82> units{{{"s", 1, "s"},
                                      {"sec", 1, "s"},
                                      {"ms", 1e-3, "s"},
                                      {"us", 1e-6, "s"},
                                      {"ns", 1e-9, "s"},
                                      {"\xC2\xB5s", 1e-6, "s"},
                                      {"\xCE\xBCs", 1e-6, "s"},
                                      {"m", 1, "m"},
                                      {"km", 1e3, "m"},
                                      {"mm", 1e-3, "m"},
                                      {"cm", 1e-2, "m"},
                                      {"km+m", 1, "m"},
                                      {"m/s", 1, "m/s"},
                                      {"km/h", 1 / 3.6, "m/s"},
                                      {"kmh", 1 / 3.6, "m/s"},
                                      {"kph", 1 / 3.6, "m/s"},
                                      {"m/s2", 1, "m/s2"},
                                      {"m/s^2", 1, "m/s2"},
                                      {"m/s**2", 1, "m/s2"},
                                      {"m/s\xC2\xB2", 1, "m/s2"},
                                      {"m s-2", 1, "m/s2"},
                                      {"ms-2", 1, "m/s2"},
                                      {"mm/s2", 1e-3, "m/s2"},
                                      {"mm/s^2", 1e-3, "m/s2"},
                                      {"g", 9.80665, "m/s2"},
                                      {"mg", 9.80665e-3, "m/s2"},
                                      {"msec", 1e-3, "s"},
                                      {"min", 60, "s"},
                                      {"dm", 1e-1, "m"},
                                      {"um", 1e-6, "m"},
                                      {"\xC2\xB5m", 1e-6, "m"},
                                      {"\xCE\xBCm", 1e-6, "m"},
                                      {"mi", 1609.344, "m"},
                                      {"mile", 1609.344, "m"},
                                      {"miles", 1609.344, "m"},
                                      {"in", 0.0254, "m"},
                                      {"inch", 0.0254, "m"},
                                      {"ft", 0.3048, "m"},
                                      {"mps", 1, "m/s"},
                                      {"mph", 0.44704, "m/s"},
                                      {"km/hr", 1 / 3.6, "m/s"},
                                      {"knots", 1852 / 3600.0, "m/s"},
                                      {"m/s/s", 1, "m/s2"},
                                      {"m*s^-2", 1, "m/s2"},
                                      {"m*s-2", 1, "m/s2"},
                                      {"mm/s\xC2\xB2", 1e-3, "m/s2"},
                                      {"cm/s2", 1e-2, "m/s2"},
                                      {"cm/s^2", 1e-2, "m/s2"},
                                      {"cm/s\xC2\xB2", 1e-2, "m/s2"},
                                      {"ft/s2", 0.3048, "m/s2"},
                                      {"gn", 9.80665, "m/s2"},
                                      {"gal", 1e-2, "m/s2"},
                                      {"n", 1, "N"},
                                      {"kn", 1e3, "N"},
                                      {"v", 1, "V"},
                                      {"mv", 1e-3, "V"},
                                      {"hz", 1, "Hz"},
                                      {"khz", 1e3, "Hz"},
                                      {"deg", 1, "deg"},
                                      {"\xC2\xB0", 1, "deg"},
                                      {"%", 1, "%"},
                                      {"-", 1, "-"},
                                      {"second", 1, "s"},
                                      {"seconds", 1, "s"},
                                      {"milliseconds", 1e-3, "s"},
                                      {"microseconds", 1e-6, "s"},
                                      {"nanoseconds", 1e-9, "s"},
                                      {"minutes", 60, "s"},
                                      {"h", 3600, "s"},
                                      {"hours", 3600, "s"},
                                      {"days", 86400, "s"},
                                      {"metre", 1, "m"},
                                      {"metres", 1, "m"},
                                      {"meter", 1, "m"},
                                      {"meters", 1, "m"},
                                      {"m s-1", 1, "m/s"},
                                      {"m.s-1", 1, "m/s"},
                                      {"m/sec", 1, "m/s"},
                                      {"m.s-2", 1, "m/s2"},
                                      {"m s^-2", 1, "m/s2"},
                                      {"m/sec2", 1, "m/s2"},
                                      {"m/sec^2", 1, "m/s2"}}};

}  // namespace

const Unit* findUnit(std::string_view text) {
  const std::string lower = lowerCase(text);
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == lower; });
  return found == units.end() ? nullptr : &*found;
}

std::string bareUnit(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '[' || text.front() == '(') && (text.back() == ']' || text.back() == ')'))
    text = trimmed(text.substr(1, text.size() - 2));
  return std::string(text);
}

bool isUnit(std::string_view text) {
  const std::string_view bare = trimmed(text);
  if (bare.size() >= 2 && bare.front() == '[' && bare.back() == ']') return true;
  return findUnit(bareUnit(text)) != nullptr;
}

std::string printedUnit(const std::string& unit) {
  if (unit == "us") return "µs";
  if (unit == "um") return "µm";
  std::string printed;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool power =
        unit[i] == '2' && i > 0 && (unit[i - 1] == ')' || std::isalpha(static_cast<unsigned char>(unit[i - 1])));
    printed += power ? std::string("²") : std::string(1, unit[i]);
  }
  return printed;
}

std::string withPrintedUnit(const std::string& nameWithUnit) {
  const std::size_t open = nameWithUnit.rfind('['), close = nameWithUnit.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return nameWithUnit;
  return nameWithUnit.substr(0, open + 1) + printedUnit(nameWithUnit.substr(open + 1, close - open - 1)) +
         nameWithUnit.substr(close);
}

std::string roundedText(double value, const std::string& unit) {
  const std::string text = roundedText(value);
  return unit.empty() || unit == "1" ? text : text + " " + printedUnit(unit);
}

}  // namespace squat::text
