// widgets/plots/GrowthFigures.h - a defect that grows under traffic.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "growth/Forecast.h"
#include "growth/Grow.h"
#include "plots/FigureSheet.h"

namespace squat::plots {

// STEM_growth: profiles along the running line at a handful of stages; what has changed, as a map from above and along
// the running line against tonnage; depth of the dip with wear and flow, peak acceleration and contact force against
// tonnage; where the rail yields, how deep its steel is strained.
FigureSheet growthFigure(const growth::Growth& growth, const std::string& stem, const Style& style);

// The profile along the running line at one stage, beside that at first.
std::unique_ptr<Figure> stageFigure(const growth::Growth& growth, std::size_t stage, const Style& style);

// Depth and length of the dip, and what the measuring wheelset feels, against tonnage from none to `end` [kg]: a growth
// that has not come so far leaves the rest of the axes empty.
std::vector<std::unique_ptr<Figure>> growthCurves(const growth::Growth& growth, double end, const Style& style);

// STEM_forecast: the band of the dip's depth against tonnage.
FigureSheet forecastFigure(const growth::Forecast& forecast, const std::string& stem, const Style& style);

}  // namespace squat::plots
