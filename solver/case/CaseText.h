// solver/case/CaseText.h - every parameter of a case for people (table) and for programs (JSON); `squat describe`.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// Keys that the call itself has set (--set), and not the case: their source is "set here".
using SetKeys = std::vector<std::string>;

// One line per parameter, grouped: key, value with unit, range, documentation with the condition under which the key
// applies, source. Values that differ from the default carry a star and name the default.
std::string describeTable(const CaseDescription& description, const SetKeys& set = {});

// An array of {key, value, unit, default, min, max, doc, group, source, default_source, applies, applies_if, kind,
// choices}. Values are numbers, strings, booleans or arrays of pairs; min and max are numbers for every number and null
// for every other kind; applies_if is null for a key that always applies.
std::string describeJson(const CaseDescription& description, const SetKeys& set = {});

}  // namespace squat::cases
