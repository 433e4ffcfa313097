// solver/case/ParameterRows.h - how rows of the parameter table are written; internal to solver/case.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"

namespace squat::cases::rows {

// A unit of the case file: SI = value * 10^power.
struct Unit {
  const char* name;
  int power;
};
inline constexpr Unit none{"-", 0}, metre{"m", 0}, millimetre{"mm", -3}, kilogram{"kg", 0}, density{"kg/m\u00B3", 0},
    gigapascal{"GPa", 9}, stiffness{"MN/m", 6}, damping{"kN s/m", 3}, kilonewton{"kN", 3}, speed{"m/s", 0},
    angularSpeed{"rad/s", 0}, torque{"N m", 0}, second{"s", 0}, millisecond{"ms", -3}, microsecond{"\u00B5s", -6},
    acceleration{"m/s\u00B2", 0}, hertz{"Hz", 0}, kilohertz{"kHz", 3}, decibel{"dB", 0};

// Sources that many rows name.
inline constexpr const char *table1 = "paper, Table 1", *section2 = "paper, section 2";

struct Range {
  double minimum, maximum;
};

Parameter number(const char* key, Unit unit, double defaultValue, Range range, double& (*access)(CaseDescription&),
                 const char* doc, const char* source);
Parameter wholeNumber(const char* key, double defaultValue, Range range, Access access, const char* doc,
                      const char* source);
Parameter choice(const char* key, std::vector<std::string> names, std::size_t defaultValue, ChoiceAccess access,
                 const char* doc, const char* source);

// Names in the order of the enumerators.
template <typename Enum>
Parameter choice(const char* key, std::vector<std::string> names, Enum defaultValue, Enum& (*access)(CaseDescription&),
                 const char* doc, const char* source) {
  // The accessors take a mutable description; reading through them does not change it.
  return choice(key, std::move(names), static_cast<std::size_t>(defaultValue),
                ChoiceAccess{[access](const CaseDescription& description) {
                               return static_cast<std::size_t>(access(const_cast<CaseDescription&>(description)));
                             },
                             [access](CaseDescription& description, std::size_t index) {
                               access(description) = static_cast<Enum>(index);
                             }},
                doc, source);
}
Parameter boolean(const char* key, bool defaultValue, bool& (*access)(CaseDescription&), const char* doc,
                  const char* source);
Parameter text(const char* key, std::string& (*access)(CaseDescription&), const char* doc, const char* source);
Parameter points(const char* key, std::vector<ProfilePoint>& (*access)(CaseDescription&), const char* doc,
                 const char* source);
Parameter lines(const char* key, std::vector<ProfileLine>& (*access)(CaseDescription&), const char* doc,
                const char* source);

Parameter forceCurve(const char* key, std::vector<ForcePoint>& (*access)(CaseDescription&), const char* doc,
                     const char* source);
Parameter seats(const char* key, std::vector<Seat>& (*access)(CaseDescription&), const char* doc, const char* source);

// The same row with a condition: it has an effect only where another key is, or is not, one of these values. Several
// conditions must all hold.
Parameter appliesIf(const char* key, std::vector<std::string> values, Parameter parameter);
Parameter appliesUnless(const char* key, std::vector<std::string> values, Parameter parameter);

// The key of an input preset (InputPresets.h), whose name the description keeps as text.
Parameter inputPreset(const char* key, std::string& (*access)(CaseDescription&), const char* doc, const char* source);

using Rows = std::vector<Parameter>;
Rows trackRows();    // track, rail, pad, sleeper, ballast
Rows vehicleRows();  // wheelset, suspension, bogie
Rows motionRows();   // motion, contact, damping
Rows runRows();      // model, mesh, output
Rows defectRows();   // defect
Rows growthRows();   // growth

}  // namespace squat::cases::rows
