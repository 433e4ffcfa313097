// solver/readers/ColumnRoles.h - what a column is, from its name and unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace squat::readers {

enum class Role { signal, time, position, speed, run, latitude, longitude };

// By name in English, Dutch or German, and by unit where the name says nothing.
Role roleOf(std::string_view name, std::string_view unit);

// Factor to SI for the role, and the SI unit's name. Unknown units keep the numbers: factor 1, unit as it is.
struct UnitScale {
  double factor = 1;
  std::string unit;
};
// Whether a unit is none, or one of time, position, speed or angle, as the role asks for.
bool isUnitOf(std::string_view unit, Role role);
UnitScale scaleOf(std::string_view unit, std::string_view name, Role role);

}  // namespace squat::readers
