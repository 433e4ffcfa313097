// solver/case/CaseText.h - every parameter of a case for people (table) and for programs (JSON); `squat describe`.
#pragma once

#include <string>

#include "case/CaseDescription.h"

namespace squat::cases {

// One line a parameter, grouped: key, value with unit, range, documentation, source of the default. Values that differ
// from the default carry a star.
std::string describeTable(const CaseDescription& description);

// An array of {key, value, unit, default, min, max, doc, group, source, kind, choices}. Values are numbers, strings,
// booleans or arrays of pairs; min and max are numbers for every number and null for every other kind.
std::string describeJson(const CaseDescription& description);

}  // namespace squat::cases
