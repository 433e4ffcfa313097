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

// A signal of unequally spaced samples on equal steps: at each instant the polynomial through the eight samples around
// it, at their own times. Signals up to a fifth of the rate come back within 1 %, up to a tenth within 1e-4. `time`
// rises; eight samples at least.
std::vector<double> onEqualSteps(const std::vector<double>& time, const std::vector<double>& values, double start,
                                 double step, std::size_t count);

// Straight line between the points of a table with rising `x`; the end values beyond.
double interpolateLinear(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace squat::signals
