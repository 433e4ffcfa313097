// solver/case/Findings.h - how the checks of relations word what they find; internal to solver/case.
#pragma once

#include <string>
#include <vector>

#include "case/Validation.h"

namespace squat::cases::relations {

using Keys = std::vector<std::string>;

// Four digits, to the side that is allowed: what a message names must be accepted.
enum class Side { nearest, below, above };
std::string rounded(double value, Side side = Side::nearest);

// "12.5 mm", four digits.
std::string millimetres(double metres);

// `limit` in SI, shown in the unit of `key`.
std::string limitText(const std::string& key, const char* relation, double limit);

// The first key is the one that the user should change.
void add(std::vector<Finding>& findings, const CaseDescription& description, Severity severity, Keys keys,
         std::string allowed, std::string advice);

}  // namespace squat::cases::relations
