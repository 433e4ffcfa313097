// solver/studies/InputRange.h - numbers of a case with the limits between which they are varied.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "case/ParameterTable.h"

namespace squat::studies {

// One number of the case and its limits, in the unit of the case file.
struct InputRange {
  const cases::Parameter* parameter = nullptr;
  double low = 0, high = 0;
  bool isRight = false;  // of the right side of a whole model

  std::string key() const;  // "pad.stiffness", "right.pad.stiffness"
  // What the case has, in the unit of the case file.
  double valueIn(const cases::CaseDescription& description) const;
};

// From "KEY=LOW:HIGH", as `option` was given. Throws CaseError with every problem: unknown key, a key that is not a
// number, limits outside the range of the table or upside down, a key given twice, none at all.
std::vector<InputRange> inputRangesFromText(const std::vector<std::string>& texts, const std::string& option);

}  // namespace squat::studies
