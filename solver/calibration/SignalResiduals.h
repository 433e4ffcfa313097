// solver/calibration/SignalResiduals.h - computed beside measured axle box acceleration, sample by sample.
#pragma once

#include <string>
#include <vector>

#include "calibration/TargetValue.h"
#include "calibration/Targets.h"
#include "results/RunResult.h"
#include "signals/Alignment.h"

namespace squat::calibration {

// The measured runs of one place, low-passed, aligned with each other and averaged.
struct MeasuredSignal {
  SignalTarget target;
  signals::Passage mean;
  double noise = 0;  // [m/s2] standard deviation that a sample of the mean is allowed
  double peak = 0;   // [m/s2] largest absolute value of the mean
  std::vector<std::string> notes;
};

// Throws FileError for files that cannot be read, runs without speed or position and signals that are not in m/s2.
MeasuredSignal readMeasured(const SignalTarget& target);

// Residuals: differences over the noise at independent samples (two for each period of the cut-off frequency), after
// the computed signal has been shifted to where both correlate best. For the search the misfit also holds the levels in
// one-third octaves, which lead to the right frequencies from afar, where samples that are out of phase say nothing.
TargetValue signalValue(const MeasuredSignal& measured, const results::RunResult& result);

}  // namespace squat::calibration
