// solver/case/DynamicPads.h - the complex stiffness of pads as a laboratory measured it: as text of a case, and files
// of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/Track.h"

namespace squat::cases {

// "200: 3863 608 155 24, 400: ...": frequency [Hz], real and imaginary part of the vertical stiffness and, in all rows
// or in none, of the lateral one [MN/m]. Nothing where the text is anything else; empty text: an empty table.
std::optional<std::vector<scenario::DynamicStiffness>> parseDynamicStiffness(std::string_view text);
std::string formatDynamicStiffness(const std::vector<scenario::DynamicStiffness>& table);

// What is wrong with a table: frequencies that do not ascend, stiffness of no pad (1 MN/m to 100 GN/m, positive loss).
// Empty: nothing.
std::string dynamicStiffnessMistake(const std::vector<scenario::DynamicStiffness>& table);

// A column of frequencies [Hz], then real and imaginary part of the vertical stiffness and, if they are there, of the
// lateral one, in N/m, N/mm, kN/mm or MN/m as the heading says. Names hold "real" and "imag", the lateral ones
// "lateral" as well; columns of another unit (Nm/rad) are left out. Throws FileError, also where a unit is missing or
// the numbers are those of no pad.
std::vector<scenario::DynamicStiffness> readDynamicStiffness(const std::string& path);

}  // namespace squat::cases
