// solver/dynamics/Rolling.h - central difference of the rolling wheel on the track.
//
// One step, everything local in memory: contact, springs and torque collect forces on surface nodes; then each stretch
// of stations computes its inner forces and is advanced at once. The rim's tied nodes pass their inner forces to the
// wheel body, which follows. Fixed partition, ordered sums: the same bits for any number of threads.
//
// Spin of the wheelset: the reference turns with rate w, I w' = torque + moment of all outer forces with displaced
// arms; in the turning reference every mass feels +a' r along alpha, I a' = torque + moment with undisplaced arms, so
// that no mean spin gathers in the displacements (false power otherwise).
#pragma once

#include <memory>
#include <vector>

#include "contact/RollingContact.h"
#include "core/ThreadTeam.h"
#include "dynamics/RollingState.h"
#include "elasticity/SweptWork.h"
#include "model/WheelMotion.h"

namespace squat::dynamics {

// What one step shows to observers; instants are those of the displacement before the step.
struct StepView {
  long step = 0;
  double time = 0, position = 0;  // [s], [m] wheel centre relative to the defect
  contact::PatchState patch;
  model::PlaneVector boxAcceleration, wheelAcceleration;  // [m/s2]
  double spinRate = 0;                                    // [rad/s]
};

class Rolling {
 public:
  Rolling(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double step, double beta);

  // Quiet start: displacements of the equilibrium, velocities that rolling implies.
  void start(const AlignedVector& displacement, const AlignedVector& velocity, double spinRate);

  // Advances `steps` steps; `observe(view)` is called on the calling thread for every step.
  template <typename Observe>
  void advance(long steps, const Observe& observe) {
    team_.run([&](int index) {
      for (long k = 0; k < steps; ++k) {
        collectForces(index);
        team_.barrier();
        advanceTrackAndRim(index);
        team_.barrier();
        passTieForces(index);
        team_.barrier();
        advanceBody(index);
        team_.barrier();
        if (index == 0) {
          finishStep();
          observe(view_);
        }
        team_.barrier();
      }
    });
  }

  const RollingState& state() const { return state_; }
  const StepView& view() const { return view_; }  // of the last step
  void restore(RollingState state);
  const model::Model& model() const { return model_; }
  double stepSize() const { return step_; }
  double beta() const { return beta_; }
  double wheelLoad() const { return load_; }
  double torqueAt(double time) const;
  ThreadTeam& team() { return team_; }
  const elasticity::KernelSet& kernels() const { return kernels_; }

  // Displacement u (state layout) with slaves and ghosts filled.
  AlignedVector displacement() const;
  // Contact points of the present state, for pictures; changes nothing.
  std::vector<contact::PatchPoint> patchPoints() const;

 private:
  void collectForces(int index);
  void advanceTrackAndRim(int index);
  void passTieForces(int index);
  void advanceBody(int index);
  void finishStep();
  void touch();
  void pushVehicle();
  contact::WheelRolling wheelRolling() const;

  const model::Model& model_;
  elasticity::KernelSet kernels_;
  ThreadTeam& team_;
  double step_, beta_, load_;
  contact::ContactLaw law_;
  RollingState state_;
  AlignedVector target_, forces_;
  std::vector<std::vector<elasticity::Segment>> trackWork_, bodyWork_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  std::vector<elasticity::BlockStep> blockSteps_;
  std::vector<AlignedVector> acceleration_;  // per block: 3 lines
  std::vector<std::vector<double>> radii_;   // per block: of section nodes, around the axis
  model::TurnedStations turned_, turnedRim_;
  AlignedVector tieWorkspace_, slaveWorkspace_;
  StepView view_;
  model::PlaneVector boxVelocity_, wheelVelocity_, hub_;
  double spinAcceleration_ = 0, referenceAcceleration_ = 0;
  double damperPower_[3] = {0, 0, 0};  // ballast, pads and ends; suspension
  double vehicleMoment_ = 0;           // of outer forces besides the contact, displaced arms
  double torque_ = 0, hubSpinRate_ = 0;
};

}  // namespace squat::dynamics
