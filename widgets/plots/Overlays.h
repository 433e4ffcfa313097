// widgets/plots/Overlays.h - curves of one run on the axis of another.
#pragma once

#include <string>

#include "plots/LineFigure.h"

namespace squat::plots {

// Moment [s] at which the wheel is over the defect, by the constant speed that links time and position.
double passageTime(const signals::Record& result);

// A signal against the wheel's position [mm], which counts from the defect, and against time [ms], shifted so that the
// wheels of both runs pass the defect at the same moment. Values are multiplied by `factor`; no points without the
// signal.
Curve againstPosition(const signals::Record& other, const std::string& signal, double factor = 1);
Curve againstTime(const signals::Record& other, const signals::Record& shown, const std::string& signal,
                  double factor = 1);

}  // namespace squat::plots
