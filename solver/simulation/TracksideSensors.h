// solver/simulation/TracksideSensors.h - points of the track whose motion a trackside sensor records.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/Rolling.h"

namespace squat::simulation {

// Vertical motion of a point as a sum of weight times unknown of the state.
using VerticalMotion = std::vector<std::pair<std::size_t, double>>;

// Middle of the rail foot at x [m] from the deepest point of the defect, interpolated between stations. Throws
// CaseError where the rail does not reach.
VerticalMotion railFootAt(const model::Model& model, double x);
// Top of the nearest sleeper, below the middle of the rail.
VerticalMotion sleeperTopNear(const model::Model& model, double x);

// Vertical acceleration [m/s2, up positive] of a point, the difference of its velocities half a step before and after.
class Accelerometer {
 public:
  Accelerometer(VerticalMotion motion, const dynamics::Rolling& rolling);
  double operator()(const dynamics::Rolling& rolling);

 private:
  double velocity(const dynamics::Rolling& rolling) const;
  VerticalMotion motion_;
  double last_;  // [m/s]
};

}  // namespace squat::simulation
