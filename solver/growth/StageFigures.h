// solver/growth/StageFigures.h - what a stage of growth is described by.
#pragma once

#include "growth/RollingTraffic.h"

namespace squat::growth {

inline constexpr double strainedFrom = 0.001;  // [-] accumulated plastic strain from which steel counts as strained

Stage stageOf(const RollingTraffic& traffic, const GrowthState& rail, const Passage& passage);

// [m] where the defect begins and ends, and y along which the wheel of the case touches.
struct DefectExtent {
  double first = 0, last = 0, touch = 0;
};
DefectExtent extentOf(const cases::CaseDescription& description);

}  // namespace squat::growth
