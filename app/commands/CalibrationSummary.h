// app/commands/CalibrationSummary.h - a calibration in words: targets, inputs, what is known and what is not.
#pragma once

#include <string>

#include "calibration/Calibration.h"

namespace squat::commands {

// Lines of at most 100 columns.
std::string calibrationSummary(const calibration::Calibration& calibration);

}  // namespace squat::commands
