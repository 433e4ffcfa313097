// solver/case/BeforeDefect.h - what of a case counts before the wheel can feel the defect: all that equilibrium, mesh
// and run-up depend on. Cases that agree in it, on a mesh for one zone, can share the state in which the wheel arrives.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"

namespace squat::cases {

// False for the profile of the defect, titles, and what is done with a finished record. The zone of the mesh is left
// out as well: a mesh for a longer one serves a shorter defect. The location of the defect on the track counts.
bool countsBeforeDefect(const Parameter& parameter);

// The keys that count and whose values differ, in the order of the table; then those that differ on the right side
// alone.
std::vector<const Parameter*> differencesBeforeDefect(const CaseDescription& one, const CaseDescription& other);

// Whether nodes of the rail are moved under the defect of a side.
bool hasMovedNodes(const CaseDescription& description);

// Eight hexadecimal digits that stand for all values that count.
std::string hashBeforeDefect(const CaseDescription& description);

}  // namespace squat::cases
