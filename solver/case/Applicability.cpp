#include "case/Applicability.h"

#include <algorithm>

#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"

namespace squat::cases {

namespace {

// Value as text; lists, which may have thousands of points, only as empty or not.
std::string briefText(const CaseDescription& description, const Parameter& parameter) {
  if (!isList(parameter)) return valueText(description, parameter);
  return isEmptyList(description, parameter) ? "[]" : "[...]";
}

bool sameValue(const Parameter& parameter, const std::string& a, const std::string& b) {
  return a == b || (parameter.kind == Kind::number && parseDecimal(a) == parseDecimal(b));
}

std::string effectiveText(const CaseDescription& description, const Parameter& parameter) {
  return applies(description, parameter) ? briefText(description, parameter) : defaultTextOf(parameter);
}

bool holds(const CaseDescription& description, const Requirement& requirement) {
  const Parameter& parameter = *findParameter(requirement.key);
  const auto value = effectiveText(description, parameter);
  const bool among = std::any_of(requirement.values.begin(), requirement.values.end(),
                                 [&](const auto& other) { return sameValue(parameter, value, other); });
  return among == (requirement.relation == Requirement::Relation::isOneOf);
}

std::string requirementText(const Requirement& requirement) {
  const bool isOneOf = requirement.relation == Requirement::Relation::isOneOf;
  if (requirement.values == std::vector<std::string>{"[]"})
    return requirement.key + (isOneOf ? " is not given" : " is given");
  std::string text = requirement.key + (isOneOf ? " is " : " is not ");
  for (std::size_t i = 0; i < requirement.values.size(); ++i)
    text += (i == 0 ? "" : i + 1 == requirement.values.size() ? " or " : ", ") + requirement.values[i];
  return text;
}

// The first requirement that is not met, in the alternative that comes first: the key that decides.
const Requirement* firstUnmet(const CaseDescription& description, const Condition& condition) {
  for (const auto& alternative : condition)
    for (const auto& requirement : alternative)
      if (!holds(description, requirement)) return &requirement;
  return nullptr;
}

}  // namespace

std::string conditionText(const Condition& condition) {
  std::string text;
  for (const auto& alternative : condition) {
    if (!text.empty()) text += ", or ";
    for (const auto& requirement : alternative)
      text += (&requirement == &alternative.front() ? "" : " and ") + requirementText(requirement);
  }
  return text;
}

bool applies(const CaseDescription& description, const Parameter& parameter) {
  if (parameter.condition.empty()) return true;
  return std::any_of(parameter.condition.begin(), parameter.condition.end(), [&](const auto& alternative) {
    return std::all_of(alternative.begin(), alternative.end(),
                       [&](const auto& requirement) { return holds(description, requirement); });
  });
}

std::string reasonWithoutEffect(const CaseDescription& description, const Parameter& parameter) {
  const Requirement* unmet = firstUnmet(description, parameter.condition);
  if (!unmet) return {};
  const Parameter& deciding = *findParameter(unmet->key);
  std::string because = deciding.key;
  if (!applies(description, deciding))
    because += " has no effect either";
  else if (isList(deciding))
    because += isEmptyList(description, deciding) ? " is not given" : " is given";
  else
    because += " is " + valueText(description, deciding);
  return "no effect because " + because + "; applies if " + conditionText(parameter.condition);
}

std::optional<CaseProblem> valueWithoutEffect(const CaseDescription& description, const Parameter& parameter) {
  if (parameter.condition.empty() || applies(description, parameter)) return std::nullopt;
  const auto value = briefText(description, parameter);
  if (sameValue(parameter, value, defaultTextOf(parameter))) return std::nullopt;
  const bool pure = parameter.unit.empty() || parameter.unit == "-" || isList(parameter);
  return CaseProblem{parameter.key, isList(parameter) ? "given" : value + (pure ? "" : " " + parameter.unit), "",
                     reasonWithoutEffect(description, parameter)};
}

}  // namespace squat::cases
