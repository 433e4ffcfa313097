#include "studies/InputRange.h"

#include <optional>

#include "case/CaseDescription.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::studies {

namespace {

CaseProblem notARange(const std::string& option, const std::string& text) {
  return {option, text, "KEY=LOW:HIGH", "Example: pad.stiffness=800:2000, in the unit of the case file"};
}

std::optional<CaseProblem> limitProblem(const cases::Parameter& parameter, const std::string& text) {
  auto description = cases::defaultCase();
  return cases::trySetValue(description, parameter, text);
}

// Adds the input or what is wrong with its text.
void addInput(const std::string& option, const std::string& text, std::vector<InputRange>& inputs,
              std::vector<CaseProblem>& problems) {
  const auto equals = text.find('='), colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || colon == std::string::npos) return problems.push_back(notARange(option, text));
  const auto low = text::numberFromText(text.substr(equals + 1, colon - equals - 1));
  const auto high = text::numberFromText(text.substr(colon + 1));
  if (!low || !high) return problems.push_back(notARange(option, text));
  const auto key = text.substr(0, equals);
  const auto* parameter = cases::findOnEitherSide(key);
  if (!parameter) return problems.push_back(cases::unknownKey(key));
  if (parameter->kind != cases::Kind::number || parameter->integer)
    return problems.push_back({option + " " + key, "", "", "Only keys whose value is a decimal number have limits"});
  if (!(*low < *high))
    return problems.push_back({option + " " + key, text.substr(equals + 1), "LOW below HIGH", "Exchange the limits"});
  for (const double limit : {*low, *high})
    if (auto problem = limitProblem(*parameter, text::numberText(limit)))
      return problems.push_back(cases::keyOnRight(key).empty() ? *problem : cases::onRight(*problem));
  for (const auto& other : inputs)
    if (other.key() == key) return problems.push_back({option + " " + key, "given twice", "given once", ""});
  inputs.push_back({parameter, *low, *high, !cases::keyOnRight(key).empty()});
}

}  // namespace

std::string InputRange::key() const { return (isRight ? std::string(cases::rightGroup) + "." : "") + parameter->key; }

double InputRange::valueIn(const cases::CaseDescription& description) const {
  return cases::numberInUnit(isRight ? cases::rightOf(description) : description, *parameter);
}

std::vector<InputRange> inputRangesFromText(const std::vector<std::string>& texts, const std::string& option) {
  std::vector<InputRange> inputs;
  std::vector<CaseProblem> problems;
  for (const auto& text : texts) addInput(option, text, inputs, problems);
  if (texts.empty()) problems.push_back(notARange(option, "missing"));
  if (!problems.empty()) throw CaseError(problems);
  return inputs;
}

}  // namespace squat::studies
