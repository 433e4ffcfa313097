// solver/text/Units.h - units as files name them, and as they are printed for people.
#pragma once

#include <string>
#include <string_view>

namespace squat::text {

struct Unit {
  std::string_view name;  // in small letters
  double factor;          // to `si`
  std::string_view si;
};

// By any of its usual names, without brackets, case ignored; null: not known.
const Unit* findUnit(std::string_view text);
bool isUnit(std::string_view text);           // known, or anything in square brackets
std::string bareUnit(std::string_view text);  // without brackets

// "m/s2" as "m/s²", "(m/s2)2/Hz" as "(m/s²)²/Hz", "us" as "µs"; in a longer text inside its square brackets.
std::string printedUnit(const std::string& unit);
std::string withPrintedUnit(const std::string& nameWithUnit);

// roundedText() and the printed unit: "103.4 m/s²"; none for "" and "1".
std::string roundedText(double value, const std::string& unit);

}  // namespace squat::text
