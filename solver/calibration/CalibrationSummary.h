// solver/calibration/CalibrationSummary.h - a calibration in words: targets, inputs, what is known and what is not.
#pragma once

#include <string>

#include "calibration/Calibration.h"

namespace squat::calibration {

// Lines of at most 100 columns.
std::string calibrationSummary(const Calibration& calibration);

}  // namespace squat::calibration
