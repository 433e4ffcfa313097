// solver/calibration/TargetChecks.h - what is wrong with targets before anything is computed.
#pragma once

#include "calibration/Targets.h"

namespace squat::calibration {

// Throws FileError where there is no target, where a signal is about a run that is not listed, where a statement gives
// another unit than its measure has, and where two statements about the same number exclude each other.
void checkTargets(const Targets& targets);

}  // namespace squat::calibration
