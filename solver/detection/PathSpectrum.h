// solver/detection/PathSpectrum.h - what a rigid wheel would feel of a squat: the spectrum of its path.
#pragma once

#include <vector>

#include "scenario/Defect.h"

namespace squat::detection {

// Energy spectrum of the second derivative w'' of the path w(x) of a rigid wheel of 0.46 m over the defect, by
// wavenumber k [1/m]: 2 |W''(k)|^2, summed from zero. At the speed v the wheel's acceleration is v^2 w''(v t).
class PathSpectrum {
 public:
  explicit PathSpectrum(const scenario::Defect& defect);

  // [m2/s3] energy of the acceleration between two frequencies [Hz]: the integral of 2 |A(f)|^2 with
  // A(f) = v W''(f/v), hence v^3 times the integral of 2 |W''(k)|^2 over k.
  double energy(double speed, double low, double high) const;

 private:
  double upTo(double wavenumber) const;

  double step_ = 1;          // [1/m]
  std::vector<double> sum_;  // [1/m] of 2 |W''|^2 dk below each multiple of the step
};

}  // namespace squat::detection
