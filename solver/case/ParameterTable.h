// solver/case/ParameterTable.h - the one table of all parameters of a case. It feeds the case file, validation, the
// form in the studio, `squat describe` and the manual; a parameter that is not in it does not exist for a user.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/CaseDeclaration.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::cases {

enum class Kind { number, choice, text, boolean, points, lines, forceCurve, seats };

// Who sets a key: everybody, in every case; who knows track and vehicle; who works on the model itself. The form shows
// one level and those before it; ParameterLevels.h lists the keys.
enum class Level { basic, advanced, expert };

// A choice, an enumerator of its own type in the description, as an index into the names of the parameter.
struct ChoiceAccess {
  std::function<std::size_t(const CaseDescription&)> index;
  std::function<void(CaseDescription&, std::size_t)> choose;
};

// Where in the description a parameter lives; which alternative goes with which kind: number -> double or int,
// choice -> ChoiceAccess, boolean -> bool, text -> string, points -> vector of profile points, lines ->
// vector of profile lines, forceCurve -> vector of force points, seats -> vector of seats.
using Access =
    std::variant<double& (*)(CaseDescription&), int& (*)(CaseDescription&), bool& (*)(CaseDescription&),
                 std::string& (*)(CaseDescription&), std::vector<scenario::ProfilePoint>& (*)(CaseDescription&),
                 std::vector<scenario::ProfileLine>& (*)(CaseDescription&),
                 std::vector<scenario::ForcePoint>& (*)(CaseDescription&),
                 std::vector<scenario::Seat>& (*)(CaseDescription&), ChoiceAccess>;

// Another key, and the values of it with which a key has an effect.
struct Requirement {
  enum class Relation { isOneOf, isNot };
  std::string key;
  Relation relation = Relation::isOneOf;
  std::vector<std::string> values;  // as the case file states them; "[]": an empty list
};
// When a key has an effect: where every requirement of one of the alternatives is met. Empty: always.
using Condition = std::vector<std::vector<Requirement>>;

struct Parameter {
  std::string key;   // path in the case file, e.g. "pad.stiffness"
  std::string unit;  // of the value in the case file, e.g. "MN/m"; "-" for a pure number, empty where there is none
  Kind kind = Kind::number;
  int powerOfTen = 0;                                 // value in SI = value in the case file times 10^powerOfTen
  double defaultValue = 0, minimum = 0, maximum = 0;  // numbers, in `unit`: default and allowed range, all finite
  bool integer = false;                               // number: whole numbers only
  std::vector<std::string> choices;                   // names a choice may take
  std::string defaultText;  // default of every kind as the case file would state it, without quotes
  std::string group;        // table of the case file: "pad"; "case" for the keys above all tables
  std::string doc;          // one line, with the condition under which the key applies
  std::string source;       // evidence of the default: "paper, Table 1", "literature: ...", "assumed: ..."
  Access access;
  Condition condition;  // Applicability.h
  Level level = Level::advanced;
};

// Points and lines: texts of many numbers, which nobody types, empty by default.
inline bool isList(const Parameter& parameter) {
  return parameter.kind == Kind::points || parameter.kind == Kind::lines;
}

// The default of a parameter as text; of a list, an empty list.
inline std::string defaultTextOf(const Parameter& parameter) {
  return isList(parameter) ? "[]" : parameter.defaultText;
}

// The key without its group: "stiffness" of "pad.stiffness".
inline std::string_view lastPart(std::string_view key) { return key.substr(key.rfind('.') + 1); }

// Every parameter, in the order of the case file: parameters of one group stand together.
const std::vector<Parameter>& parameterTable();

const Parameter* findParameter(std::string_view key);  // nullptr: no such key

// Letters changed, added or left out from one word to the other.
int editDistance(std::string_view a, std::string_view b);

// The known key with the smallest edit distance; a key of another table with the same last part counts as near.
// Empty where nothing is near.
std::string nearestKey(std::string_view key);

// Every parameter at its default (mesh preset draft included).
CaseDescription defaultCase();

}  // namespace squat::cases
