// solver/case/Validation.h - whether a case can be run, and what its user should know before.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Errors.h"

namespace squat::cases {

enum class Severity { problem, warning };

struct Finding {
  Severity severity = Severity::problem;
  CaseProblem problem;
  std::vector<std::string> keys;  // all keys that take part
};

// Relations between keys; each value on its own is taken as within its range.
std::vector<Finding> validateRelations(const CaseDescription& description);

struct Validation {
  std::vector<CaseProblem> problems;  // the case cannot be run
  std::vector<CaseProblem> warnings;  // it can, but the result may not be what is expected
};

// Ranges of every key, then relations among those that are within their range. Cheap; never throws.
Validation validate(const CaseDescription& description);

}  // namespace squat::cases
