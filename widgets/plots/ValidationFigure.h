// widgets/plots/ValidationFigure.h - the judged statements of the paper, one a row: where our number lies in the range
// that counts as met.
#pragma once

#include <string>
#include <vector>

#include "plots/FigureSheet.h"
#include "statements/Judge.h"

namespace squat::plots {

// "validation". Ranges with one bound are drawn in units of it; numbers more than half a range outside stand at the
// edge. Rows that are not judged have no mark.
FigureSheet validationFigure(const std::vector<statements::Judged>& judged, const std::string& note,
                             const Style& style);

}  // namespace squat::plots
