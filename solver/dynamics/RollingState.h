// solver/dynamics/RollingState.h - everything that changes while the wheel rolls; a checkpoint holds just this.
#pragma once

#include "contact/RollingContact.h"
#include "core/AlignedVector.h"
#include "plasticity/SurfaceLayer.h"

namespace squat::dynamics {

struct EnergySums {
  double friction = 0, damping = 0, torqueWork = 0;  // [J] since the start
};

struct RollingState {
  AlignedVector displaced;  // u + beta v, state layout
  AlignedVector velocity;   // half a step behind the displacement [m/s]
  long step = 0;
  double time = 0;             // [s] of the displacement
  double rotation = 0;         // [rad]
  double angularVelocity = 0;  // [rad/s] half a step behind
  contact::FrictionHistory friction;
  plasticity::LayerState plastic;  // empty where nothing may yield
  EnergySums sums;
  // Of the last step (Rolling.h), [N m]: -S, inner forces about displaced positions; what contact inertia resists.
  double turningMoment = 0, addedMoment = 0;
};

}  // namespace squat::dynamics
