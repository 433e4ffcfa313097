// solver/calibration/FreeInput.h - the inputs of a case that a calibration may change, and where it looks for them.
#pragma once

#include <string>
#include <vector>

#include "studies/InputRange.h"

namespace squat::calibration {

using FreeInput = studies::InputRange;

// A value for each free input, in their order and in the units of the case file; six significant digits, so that the
// text of a table stands for exactly the same case.
using Values = std::vector<double>;

// A point of the search: every input from 0 (its lower limit) to 1.
using UnitPoint = std::vector<double>;

// From "KEY=LOW:HIGH"; throws as studies::inputRangesFromText().
std::vector<FreeInput> freeInputsFromText(const std::vector<std::string>& texts);

Values valuesAt(const std::vector<FreeInput>& inputs, const UnitPoint& point);
UnitPoint pointOf(const std::vector<FreeInput>& inputs, const Values& values);

std::string valueText(double value);  // six significant digits

}  // namespace squat::calibration
