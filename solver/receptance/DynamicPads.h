// solver/receptance/DynamicPads.h - the complex stiffness of pads as a laboratory measured it, from a table.
#pragma once

#include <string>
#include <vector>

#include "scenario/Scenario.h"

namespace squat::receptance {

// A column of frequencies [Hz], then real and imaginary part of the vertical stiffness and, if they are there, of the
// lateral one, in N/m, N/mm, kN/mm or MN/m as the heading says; imaginary positive. Names hold "real" and "imag", the
// lateral ones "lateral" as well; columns of another unit (Nm/rad) are left out. Throws FileError, also where a unit is
// missing or the stiffness is that of no pad (1 MN/m to 100 GN/m).
std::vector<scenario::DynamicStiffness> readDynamicStiffness(const std::string& path);

// The case with the pads that it names by pad.dynamic read. Throws FileError.
scenario::Scenario withDynamicPads(scenario::Scenario scenario);

}  // namespace squat::receptance
