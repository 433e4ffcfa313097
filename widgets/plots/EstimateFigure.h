// widgets/plots/EstimateFigure.h - an estimated profile with its bounds, and what it makes of the measured passages.
#pragma once

#include "plots/FigureSheet.h"

namespace squat::estimation {
struct Estimate;
}

namespace squat::plots {

// Sheet "estimate": the profile with its 90 % bounds, stretches that the wheel does not feel dashed; then each passage,
// measured and computed along the track.
FigureSheet estimateFigure(const estimation::Estimate& estimate, const Style& style);

}  // namespace squat::plots
