// solver/calibration/ReceptanceResiduals.h - computed beside measured receptance of the unloaded track.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "calibration/TargetValue.h"
#include "calibration/Targets.h"
#include "receptance/Receptance.h"

namespace squat::calibration {

struct MeasuredReceptance {
  ReceptanceTarget target;
  std::vector<double> frequency;                 // [Hz] within the limits of the target, at most 60, equal ratios
  std::vector<std::complex<double>> receptance;  // [m/N]; real where only the magnitude was measured
  bool hasPhase = false;
};

// A table whose first column is the frequency [Hz]; then columns with "magnitude", "real" or "re" and "imaginary" or
// "im", "phase" or "angle" [deg, rad] in their names, those of the target's point where the names tell points apart, or
// one other column of magnitudes. Coherence is left out. Receptances (m/N, um/kN), mobilities (m/s/N) and accelerances
// (m/s2/N, g/N) become receptances. Throws FileError, also where a unit is not stated.
MeasuredReceptance readMeasuredReceptance(const ReceptanceTarget& target);

// Residuals: difference of the magnitudes in dB over the tolerance and, where it was measured, of the phases over the
// angle that goes with it: 1 dB is ln(10) / 20 = 0.115 of the magnitude, and 0.115 rad are 6.6 degrees (real and
// imaginary part of the logarithm of the receptance).
TargetValue receptanceValue(const MeasuredReceptance& measured, const receptance::TrackReceptance& computed);

// The unit that would explain magnitudes that lie far from the computed ones ("measured magnitudes are about 1e+06
// times the computed ones"); empty where they are plausible. For the first point of a search.
std::string unitDoubt(const MeasuredReceptance& measured, const receptance::TrackReceptance& computed);

}  // namespace squat::calibration
