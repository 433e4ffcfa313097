// solver/signals/Resample.h - values between the samples.
#pragma once

#include <cstddef>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

// Value at any time by a Kaiser-windowed sinc over `reach` samples to each side, times `bandwidth` (at most 1) of the
// sampling rate: signals up to 0.4 of the rate come back within 1e-4. Beyond the record its end samples count.
class Interpolator {
 public:
  // Keeps a reference: the series must outlive it.
  explicit Interpolator(const TimeSeries& series, double bandwidth = 1.0);
  double operator()(double time) const;

 private:
  const TimeSeries& series_;
  double bandwidth_;
  int reach_;
};

// The record on another step, from the same start to its end; low-passed first where the new step is longer.
TimeSeries resample(const TimeSeries& series, double step);

// Straight line between the points of a table with rising `x`; the end values beyond.
double interpolateLinear(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace squat::signals
