// widgets/studio/preview/GrowingCurve.h - the axle box acceleration of a run that is still rolling, low-passed anew
// whenever it is looked at.
#pragma once

#include <vector>

#include "simulation/WarmState.h"

namespace squat::studio {

class GrowingCurve {
 public:
  // Begins with what the state has recorded. `rate` of the samples and `cutoff` of the low-pass in Hz.
  GrowingCurve(const simulation::WarmState& state, double rate, double cutoff);

  void add(double position, double acceleration);  // [m], [m/s2] unfiltered
  const std::vector<double>& position() const { return position_; }
  // As a run filters its whole record: near the end of a part it is still going to change a little. Unfiltered where
  // there are too few samples.
  std::vector<double> filtered() const;

 private:
  double rate_, cutoff_;
  std::vector<double> position_, acceleration_;
};

}  // namespace squat::studio
