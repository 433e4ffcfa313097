// solver/case/CaseNames.h - what tells cases apart, and names made from it: "depth 0.15, speed 40, draft".
#pragma once

#include <string>
#include <vector>

#include "case/ParameterTable.h"

namespace squat::cases {

// A value as it is compared and as it is shown, in the unit of the case file. Both are empty where it changes no result
// (a title, a key without effect) or is what the mesh preset sets.
struct ComparedValue {
  std::string identity;
  std::string shown;  // of a list: its extent, "0.15 deep, 40 long"
};

// One value a row of parameterTable(), then one a row again for what a whole model has on its right side other than on
// its left one. Made once a case: comparing them is cheap.
using ComparedCase = std::vector<ComparedValue>;
ComparedCase comparedCase(const CaseDescription& description);

// Whose value stands in such a row: a key of the table, "right.defect.depth" in the second half.
const Parameter& comparedParameter(std::size_t row);
std::string comparedKey(std::size_t row);
std::string comparedLabel(std::size_t row);  // "depth", "right depth"

// Rows that are not the same in all cases: defect first, then in the table's order, mesh and output last.
std::vector<std::size_t> differingRows(const std::vector<const ComparedCase*>& cases);

// The words of a key as they are printed: "young_modulus" is "Young's modulus", "sleeper_spacing" "sleeper spacing".
std::string printedWords(const std::string& key);

// "depth", "pad stiffness": without the table of the case file where it says nothing new.
std::string shortLabel(const Parameter& parameter);

struct CaseToName {
  std::string stem;  // name of the case file without its ending
  const ComparedCase* values = nullptr;
};

// A name for each, no two the same: what differs between the cases of one stem, at most four values of them; the stem
// before it where there are several, or where nothing differs. "light-defect (2)": the second of that name.
std::vector<std::string> caseNames(const std::vector<CaseToName>& cases);

}  // namespace squat::cases
