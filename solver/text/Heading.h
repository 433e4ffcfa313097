// solver/text/Heading.h - what the heading of a column says: its name and the unit that stands with it.
#pragma once

#include <string>
#include <string_view>

namespace squat::text {

struct Heading {
  std::string name, unit;  // unit: empty where none is stated
};

// "aba [m/s2]", "aba (g)", "time, ms", "time_ms", "speed kmh", "chainage-km", "speed in km/h". A unit without brackets
// counts only where it is one of the quantity that the name stands for: "time_ms" is time in ms, "left_v" is a name.
Heading headingOf(std::string_view text);

// The same of a column that is known to hold what has this SI unit, whatever its name: "x mm" of one of lengths.
Heading headingOf(std::string_view text, std::string_view siUnit);

// The same of a name whose unit stands elsewhere: only brackets part it.
Heading bracketedHeading(std::string_view text);

// The SI unit of what a column's name stands for, in English, German, Dutch or French: "s" for a time, "m" for a
// position along the track, "m/s" for a speed, "m/s2" for an acceleration; empty where the name says none of these.
std::string_view siUnitOfName(std::string_view name);

}  // namespace squat::text
