// solver/laboratory/PrintedUnit.h - units as they are printed for people: files keep the plain ones.
#pragma once

#include <string>

namespace squat::laboratory {

// "m/s2" as "m/s²", "(m/s2)2/Hz" as "(m/s²)²/Hz", "us" as "µs"; in a longer text inside its square brackets.
std::string printedUnit(const std::string& unit);
std::string withPrintedUnit(const std::string& nameWithUnit);

}  // namespace squat::laboratory
