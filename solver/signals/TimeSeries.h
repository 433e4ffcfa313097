// solver/signals/TimeSeries.h - a uniformly sampled signal.
#pragma once

#include <string>
#include <vector>

namespace squat::signals {

struct TimeSeries {
  double start = 0.0;  // [s] time of the first sample
  double step = 0.0;   // [s] between samples, positive
  std::vector<double> values;
  std::string name;
  std::string unit;

  double rate() const { return 1.0 / step; }
  double timeAt(std::size_t i) const { return start + step * static_cast<double>(i); }
};

}  // namespace squat::signals
