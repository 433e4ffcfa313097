#include "calibration/FreeInput.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "case/ParameterValue.h"
#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::calibration {

namespace {

CaseProblem notARange(const std::string& text) {
  return {"--free", text, "KEY=LOW:HIGH", "Example: --free pad.stiffness=800:2000, in the unit of the case file"};
}

std::optional<CaseProblem> limitProblem(const cases::Parameter& parameter, const std::string& text) {
  auto description = cases::defaultCase();
  return cases::trySetValue(description, parameter, text);
}

// Adds the input or what is wrong with its text.
void addInput(const std::string& text, std::vector<FreeInput>& inputs, std::vector<CaseProblem>& problems) {
  const auto equals = text.find('='), colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || colon == std::string::npos) return problems.push_back(notARange(text));
  const auto low = text::numberFromText(text.substr(equals + 1, colon - equals - 1));
  const auto high = text::numberFromText(text.substr(colon + 1));
  if (!low || !high) return problems.push_back(notARange(text));
  const auto key = text.substr(0, equals);
  const auto* parameter = cases::findParameter(key);
  if (!parameter) return problems.push_back(cases::unknownKey(key));
  if (parameter->kind != cases::Kind::number || parameter->integer)
    return problems.push_back({"--free " + key, "", "", "Only keys whose value is a decimal number can be calibrated"});
  if (!(*low < *high))
    return problems.push_back({"--free " + key, text.substr(equals + 1), "LOW below HIGH", "Exchange the limits"});
  for (const double limit : {*low, *high})
    if (auto problem = limitProblem(*parameter, text::numberText(limit))) return problems.push_back(*problem);
  for (const auto& other : inputs)
    if (other.key() == key) return problems.push_back({"--free " + key, "given twice", "given once", ""});
  inputs.push_back({parameter, *low, *high});
}

}  // namespace

std::vector<FreeInput> freeInputsFromText(const std::vector<std::string>& texts) {
  std::vector<FreeInput> inputs;
  std::vector<CaseProblem> problems;
  for (const auto& text : texts) addInput(text, inputs, problems);
  if (texts.empty()) problems.push_back(notARange("missing"));
  if (!problems.empty()) throw CaseError(problems);
  return inputs;
}

std::string valueText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

Values valuesAt(const std::vector<FreeInput>& inputs, const UnitPoint& point) {
  Values values;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double share = std::clamp(point[i], 0.0, 1.0);
    const double value = inputs[i].low + share * (inputs[i].high - inputs[i].low);
    values.push_back(text::numberFromText(valueText(value)).value_or(value));
  }
  return values;
}

UnitPoint pointOf(const std::vector<FreeInput>& inputs, const Values& values) {
  UnitPoint point;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    point.push_back((values[i] - inputs[i].low) / (inputs[i].high - inputs[i].low));
  return point;
}

}  // namespace squat::calibration
