// solver/analysis/WheelForces.h - the smallest force of each wheel on the rail, and whether the wheel leaves it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signals/Record.h"

namespace squat::analysis {

struct WheelForce {
  std::string wheel;              // "wheel", "right wheel", "left wheel of the second wheelset"
  double smallest = 0;            // [N] on the rail, down positive; 0 where the wheel lifts off
  std::optional<double> liftOff;  // [s] first sample without contact; none: the wheel stays on the rail
  double aloft = 0;               // [s] in all
};

// Of the wheels whose contact force the record holds, left before right, the first wheelset before the second one. What
// is shorter than a sample is not seen.
std::vector<WheelForce> wheelForces(const signals::Record& record);

}  // namespace squat::analysis
