// solver/elasticity/StandingWave.h - one interval of a swept block in a standing wave along the sweep.
//
// With u_b, u_c ~ cos and u_a ~ sin of the station's phase, sums and differences over an interval are cos and sin of
// its middle times constants: the block falls apart into problems of the size of one section, one for each wave length.
#pragma once

#include <Eigen/Core>

#include "elasticity/SweptBlock.h"

namespace squat::elasticity {

// Dense S and T of a run of a prepared block (SweptBlock.h), unknowns 3 node + component.
struct IntervalMatrices {
  Eigen::MatrixXd s, t;
};
IntervalMatrices intervalMatrices(const SweptBlock& block, int run);

// Stiffness of the wave's amplitudes for one interval that spans the phase 2 `half` [rad]; its mass is that of the
// interval.
Eigen::MatrixXd standingWaveStiffness(const IntervalMatrices& interval, double half);

}  // namespace squat::elasticity
