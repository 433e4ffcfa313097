// solver/case/ParameterValue.h - values of parameters by key, as the text that a user types; for --set, the studio's
// form and the case file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/ParameterTable.h"
#include "core/Errors.h"

namespace squat::cases {

// Value as text in the unit of the case file, without quotes: "1300", "true", "cosine". Points: "[[0, -0.1], [5, 0]]".
std::string valueText(const CaseDescription& description, const Parameter& parameter);

// Only for parameters whose value is a list (isList).
bool isEmptyList(const CaseDescription& description, const Parameter& parameter);

// Sets a value from such text. Returns the problem, and leaves the description as it was, where the text is of the
// wrong type, not finite, out of range or not a known name.
std::optional<CaseProblem> trySetValue(CaseDescription& description, const Parameter& parameter, std::string_view text);

// The same by key; throws CaseError, also for an unknown key (with the nearest known one).
void setValue(CaseDescription& description, std::string_view key, std::string_view text);

void setToDefault(CaseDescription& description, const Parameter& parameter);

// Number in the unit of the case file. Only for parameters of kind number.
double numberInUnit(const CaseDescription& description, const Parameter& parameter);

// The problem of a value that stands in the description: out of range, not finite, no such choice.
std::optional<CaseProblem> checkRange(const CaseDescription& description, const Parameter& parameter);

// "1 to 20000 MN/m", "one of free, clamped, absorbing", "true or false", ...
std::string allowedText(const Parameter& parameter);

// The problem "unknown key" with the nearest known key as advice.
CaseProblem unknownKey(std::string_view key);

}  // namespace squat::cases
