// widgets/plots/GrowthFigures.h - a defect that grows under traffic.
#pragma once

#include <string>

#include "growth/Grow.h"
#include "plots/FigureSheet.h"

namespace squat::plots {

// STEM_growth: profiles along the running line at a handful of stages, what has changed as a map from above, depth of
// the dip with wear and flow, and peak acceleration and contact force against tonnage.
FigureSheet growthFigure(const growth::Growth& growth, const std::string& stem, const Style& style);

}  // namespace squat::plots
