// solver/dynamics/ContactPhase.h - the contact of a step: points that may touch, patch, forces and added inertia.
#pragma once

#include <vector>

#include "contact/RollingContact.h"
#include "dynamics/ContactInertia.h"
#include "dynamics/RollingState.h"

namespace squat::dynamics {

class ContactPhase {
 public:
  // `step`, `beta` [s] of the central difference. Keeps a reference to the model.
  ContactPhase(const model::Model& model, double step, double beta);

  // Before the first step from a state.
  void restart(long step) { nearUntil_ = step; }
  // Patch of the wheel in this state: updates its friction history, adds the forces to the force buffer and hands the
  // closed points to the inertia, which is to be applied before a station is advanced.
  contact::PatchState evaluate(const contact::WheelRolling& wheel, RollingState& state, double* forces);
  ContactInertia& inertia() { return inertia_; }
  const ContactInertia& inertia() const { return inertia_; }

  // Contact points of a state, for pictures; changes nothing.
  std::vector<contact::PatchPoint> points(const contact::WheelRolling& wheel, const RollingState& state) const;
  // [m] x of the foremost point whose gap is below `margin` [m]; minus infinity where there is none.
  double front(double margin, const contact::WheelRolling& wheel, const RollingState& state) const;

 private:
  void listNearPoints(const contact::WheelPlacement& wheel, const RollingState& state);
  contact::ForceLines linesOf(int block, double* forces) const;
  contact::ContactMotion motionOf(const contact::WheelRolling& wheel, const RollingState& state) const;

  const model::Model& model_;
  double step_;
  contact::ContactPair pair_;
  std::vector<contact::RailPoint> near_;  // points that may close before step nearUntil_
  long nearUntil_ = 0;
  ContactInertia inertia_;
};

}  // namespace squat::dynamics
