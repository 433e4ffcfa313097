// widgets/plots/CalibrationFigure.h - what a calibration found of each input.
#pragma once

#include "calibration/Calibration.h"
#include "plots/FigureSheet.h"

namespace squat::plots {

// Sheet "calibration": a panel for each free input, misfit of every computed point against its value. Points that are
// as good as the best stand out, their range is a band; points that could not be run are left out.
FigureSheet calibrationFigure(const calibration::Calibration& calibration, const Style& style);

}  // namespace squat::plots
