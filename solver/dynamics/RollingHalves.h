// solver/dynamics/RollingHalves.h - what two halves of a wheelset that roll together need besides themselves; internal
// to Rolling.
#pragma once

#include <vector>

#include "dynamics/Rolling.h"
#include "model/CentrePlane.h"

namespace squat::dynamics {

struct Rolling::Halves {
  Halves(const model::Model& model, double step)
      : axle(axleCentre(model)),
        antisymmetric(model, step, model::Centre::antisymmetric),
        mean(model.stateSize, 0.0),
        difference(model.stateSize, 0.0) {
    for (int i = 0; i < model.sleepers; ++i) sleepers.push_back(sleeperCentre(model, model.firstSleeper + i));
  }
  model::CentreNodes axle;
  std::vector<model::CentreNodes> sleepers;
  double lateralDamperPower = 0;  // [W] of both suspensions
  model::WheelsetDamping antisymmetric;
  AlignedVector mean, difference;  // velocities, state layout; of the wheelset alone
};

}  // namespace squat::dynamics
