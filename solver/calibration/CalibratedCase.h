// solver/calibration/CalibratedCase.h - the case that a calibration found.
#pragma once

#include <string>

#include "calibration/Calibration.h"

namespace squat::calibration {

// A case file with the values of the best point, each marked as estimated with its range. Its mesh is the user's.
std::string calibratedCase(const Calibration& calibration);

}  // namespace squat::calibration
