// solver/calibration/LocalSearch.h - downhill from one point, without derivatives.
#pragma once

#include <functional>
#include <optional>

#include "calibration/FreeInput.h"

namespace squat::calibration {

// The misfit at a point of the unit cube; nothing ends the search.
using Misfit = std::function<std::optional<double>(const UnitPoint&)>;

struct LocalSearchOptions {
  int evaluations = 40;
  double firstStep = 0.12;  // in the unit cube
  double lastStep = 0.01;
};

// BOBYQA within the unit cube (quadratic models through 2 n + 1 points; NLopt). The same calls for the same misfits.
// For a single input, which BOBYQA does not take, Nelder and Mead's simplex of the same library.
void searchFrom(const UnitPoint& start, const Misfit& misfit, const LocalSearchOptions& options);

}  // namespace squat::calibration
