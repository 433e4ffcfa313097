// solver/case/Applicability.h - whether a key of a case has an effect. Each row of the parameter table says when it has
// (Parameter::condition); a key without effect counts as its default for the keys that depend on it.
#pragma once

#include <optional>
#include <string>

#include "case/ParameterTable.h"
#include "core/Errors.h"

namespace squat::cases {

// "defect.shape is cut or cosine", "defect.lateral is parabolic, or defect.lines is given"; empty: always.
std::string conditionText(const Condition& condition);

bool applies(const CaseDescription& description, const Parameter& parameter);

// The warning of a key that has been given a value other than its default and has no effect; names the key that
// decides.
std::optional<CaseProblem> valueWithoutEffect(const CaseDescription& description, const Parameter& parameter);

// "no effect because defect.shape is profile; applies if defect.shape is cut". Only where the key does not apply.
std::string reasonWithoutEffect(const CaseDescription& description, const Parameter& parameter);

}  // namespace squat::cases
