// widgets/plots/ComparisonFigures.h - two signals of one place beside each other.
#pragma once

#include <vector>

#include "analysis/FileComparison.h"
#include "plots/FigureSheet.h"

namespace squat::plots {

// Four panels: both signals on one axis, their difference, both densities, and the ratio of the densities where the
// second is above a thousandth of its largest value (elsewhere the ratio says nothing). With `smooth` the words are
// those of a defect against the same track without it.
FigureSheet comparisonFigure(const signals::Comparison& comparison, const std::string& name, bool smooth,
                             const Style& style);

// One sheet a pair, NAME_comparison.
std::vector<FigureSheet> comparisonFigures(const std::vector<analysis::FileComparison>& comparisons, bool smooth,
                                           const Style& style);

}  // namespace squat::plots
