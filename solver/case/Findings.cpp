#include "case/Findings.h"

#include <cmath>
#include <utility>

#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"

namespace squat::cases::relations {

namespace {

std::string withUnit(const std::string& text, const Parameter& parameter) {
  return parameter.unit.empty() || parameter.unit == "-" ? text : text + " " + parameter.unit;
}

}  // namespace

std::string rounded(double value, Side side) {
  if (value == 0 || !std::isfinite(value)) return formatDecimal(value);
  const double scale = std::pow(10.0, 3 - std::floor(std::log10(std::abs(value)))), digits = value * scale;
  constexpr double roundOff = 1e-6;
  const double kept = side == Side::nearest ? std::round(digits)
                      : side == Side::below ? std::floor(digits + roundOff)
                                            : std::ceil(digits - roundOff);
  return formatDecimal(kept / scale);
}

std::string millimetres(double metres) { return rounded(1e3 * metres) + " mm"; }

std::string limitText(const std::string& key, const char* relation, double limit) {
  const Parameter& parameter = *findParameter(key);
  const std::string words = relation;
  const Side side = words.find("at most") != std::string::npos    ? Side::below
                    : words.find("at least") != std::string::npos ? Side::above
                                                                  : Side::nearest;
  return words + " " + withUnit(rounded(limit * std::pow(10.0, -parameter.powerOfTen), side), parameter);
}

void add(std::vector<Finding>& findings, const CaseDescription& description, Severity severity, Keys keys,
         std::string allowed, std::string advice) {
  const Parameter& parameter = *findParameter(keys.front());
  constexpr std::size_t shownAtMost = 60;  // signs of a table as text
  std::string value = isList(parameter) ? "" : withUnit(valueText(description, parameter), parameter);
  if (value.size() > shownAtMost) value = value.substr(0, shownAtMost) + "...";
  findings.push_back({severity, {keys.front(), value, std::move(allowed), std::move(advice)}, std::move(keys)});
}

}  // namespace squat::cases::relations
