// solver/calibration/DecayResiduals.h - computed beside measured track decay rates, third octaves in dB.
#pragma once

#include <vector>

#include "calibration/TargetValue.h"
#include "calibration/Targets.h"
#include "receptance/DecayFiles.h"

namespace squat::calibration {

struct MeasuredDecays {
  DecayTarget target;
  receptance::MeasuredDecayRates rates;
};

// Throws FileError (receptance/DecayFiles.h), also where no third octave lies within the limits of the target.
MeasuredDecays readMeasuredDecays(const DecayTarget& target);

// Residuals: 10 lg of computed over mean measured rate, in each third octave and direction that was measured, over the
// tolerance or half the range of the measurements in dB, whichever is larger. Ten, since the sound that a rail gives
// off goes with the length that moves, 1 / rate.
TargetValue decayValue(const MeasuredDecays& measured, const receptance::DecayRates& computed);

}  // namespace squat::calibration
