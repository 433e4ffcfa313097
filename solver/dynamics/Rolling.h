// solver/dynamics/Rolling.h - central difference of the rolling wheel on the track.
//
// One step, everything local in memory, four meetings of the threads: contact, force elements and torque collect forces
// on surface nodes, and tied nodes take the displacements of their masters; every thread reads what it needs beyond its
// stretches of stations; then each stretch computes its inner forces and is advanced at once, in place. The rim's tied
// nodes pass their inner forces to the wheel body, which follows. Fixed partition, ordered sums: the same bits for any
// number of threads.
//
// Plastic flow of the rail's surface layer (plasticity/): elements around the patch are returned to yield while contact
// and force elements collect forces; each thread adds the forces of plastic strain to the stations that it advances.
// The start is elastic: what yields under the wheel at rest flows in the first step.
//
// Angular velocity of the wheelset: in the turning reference every mass feels +a' r along alpha,
//   I a' = torque + moment of the outer forces with undisplaced arms + what the contact's added inertia resists,
// so that no mean rotation gathers in the displacements; the reference turns about its centre of mass, which lumped
// masses leave some micrometres beside the axis. It turns with rate w, I w' = I a' - S, S the moment of the inner
// forces about the displaced positions, sum of (e x u) . f: the power w S is what the stored energy, which knows the
// displacements in the turning basis, misses of the inner forces' work. S and the added inertia's moment are taken from
// the step before.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "contact/RollingContact.h"
#include "core/ThreadTeam.h"
#include "dynamics/ContactInertia.h"
#include "dynamics/RollingState.h"
#include "elasticity/SweptWork.h"
#include "forces/ForceShares.h"
#include "model/WheelMotion.h"
#include "model/WheelsetDamping.h"
#include "plasticity/LayerWork.h"

namespace squat::dynamics {

// What one step shows to observers; instants are those of the displacement before the step.
struct StepView {
  long step = 0;
  double time = 0, position = 0;  // [s], [m] wheel centre relative to the defect
  contact::PatchState patch;
  model::PlaneVector boxAcceleration, wheelAcceleration;  // [m/s2]
  double angularVelocity = 0;                             // [rad/s]
};

class Rolling {
 public:
  Rolling(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double step, double beta);

  // Steady-rolling start: displacements of the equilibrium, velocities that rolling implies.
  void start(const AlignedVector& displacement, const AlignedVector& velocity, double angularVelocity);

  // Advances `steps` steps; `observe(view)` is called on the calling thread for every step.
  template <typename Observe>
  void advance(long steps, const Observe& observe) {
    const long first = state_.step;
    team_.run([&](int index) {
      for (long k = 0; k < steps; ++k) {
        if (index == 0) {
          if (k > 0) {
            finishStep();
            observe(view_);
          }
          pushWheelset();
        }
        pushForceElements(index);
        if (!wheelsetOfOne_) placeTiedNodes(index);
        yieldLayer(index, first + k);
        readEnds(index, false);
        team_.barrier();
        if (index == 0) sumDamperPower();
        if (wheelsetOfOne_) placeTiedNodes(index);
        readEnds(index, true);
        if (!wheelsetOfOne_) team_.barrier();
        advanceFine(index);
        if (!wheelsetOfOne_) team_.barrier();
        passTieForces(index);
        advanceMasters(index);
        fix(fixedOf_[index]);
        team_.barrier();
      }
    });
    finishStep();
    observe(view_);
  }

  const RollingState& state() const { return state_; }
  const StepView& view() const { return view_; }  // of the last step
  void restore(RollingState state);
  const model::Model& model() const { return model_; }
  double stepSize() const { return step_; }
  double beta() const { return beta_; }
  const plasticity::LayerForces& layerForces() const { return layerForces_; }
  double wheelLoad() const { return load_; }
  double torqueAt(double time) const;
  ThreadTeam& team() { return team_; }
  const elasticity::KernelSet& kernels() const { return kernels_; }
  double contactInertia() const { return inertia_.addedMass(); }  // [kg] that closed points add, in the last step

  // Displacement u (state layout) with slaves and ghosts filled.
  AlignedVector displacement() const;
  // Contact points of the present state, for pictures; changes nothing.
  std::vector<contact::PatchPoint> patchPoints() const;
  // [m] x of the foremost contact point whose gap is below `margin` [m]; minus infinity where there is none.
  double frontOfContact(double margin) const;

 private:
  void pushWheelset();  // contact, irregular elements, torque, angular acceleration
  void pushForceElements(int index);
  void sumDamperPower();
  void placeTiedNodes(int index);
  void yieldLayer(int index, long step);
  void readEnds(int index, bool late);
  void advanceFine(int index);  // and what is tied to nothing
  void passTieForces(int index);
  void advanceMasters(int index);
  void finishStep();
  void fix(const std::vector<std::size_t>& unknowns);
  void listNearPoints(const contact::WheelPlacement& wheel);
  void evaluateContact();
  void applyHubForce();
  model::PlaneVector boxVelocity() const;
  contact::WheelRolling wheelRolling(const double* displaced) const;
  double positionOf(const contact::WheelRolling& wheel) const;

  const model::Model& model_;
  elasticity::KernelSet kernels_, askedKernels_;  // the latter in the precision that the case asks for
  ThreadTeam& team_;
  double step_, beta_, load_;
  contact::ContactLaw law_;
  std::vector<contact::RailPoint> near_;  // points that may close before step nearUntil_
  long nearUntil_ = 0;
  ContactInertia inertia_;
  RollingState state_;
  AlignedVector forces_;
  std::vector<std::vector<elasticity::Segment>> fineWork_, masterWork_;
  bool wheelsetOfOne_ = false;  // the last thread has all of it
  std::vector<std::vector<elasticity::SegmentEnds>> fineEnds_, masterEnds_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  std::vector<elasticity::BlockStep> blockSteps_;
  std::vector<unsigned char> endsLate_;  // per block: its ends are read when slaves are placed
  model::WheelsetDamping wheelsetDamping_;
  std::vector<AlignedVector> acceleration_;  // per block: 3 lines
  std::vector<AlignedVector> inverseMass_;   // per block, in chunks
  std::vector<std::vector<double>> evenInverse_;
  std::vector<std::vector<double>> radii_;  // per block: of section nodes, around the axis
  model::TurnedStations turned_, turnedRim_;
  plasticity::LayerKernels layerKernels_;
  plasticity::LayerForces layerForces_;
  StepView view_;
  model::PlaneVector boxVelocity_, wheelVelocity_;
  double angularAcceleration_ = 0, referenceAcceleration_ = 0;
  double damperPower_ = 0;                 // [W]
  std::vector<double> groupDamperPowers_;  // [W] of each group of force elements, written while they push
  struct TieShare {
    std::size_t tie = 0;
    elasticity::StationSpan masters;
    std::vector<elasticity::StationSpan> slaves;
  };
  int ownerOf(std::size_t unknown) const;  // thread that advances it
  void shareBlocks();
  void requireWholeSleepers() const;
  void shareTies();
  void shareFixed();
  void shareForceElements();
  std::vector<forces::ForceShare> forceShares_;     // per thread
  std::vector<std::vector<std::size_t>> fixedOf_;   // per thread: fixed unknowns of its stations
  std::vector<std::vector<TieShare>> tieShares_;    // per thread: master stations that it advances
  std::vector<std::vector<TieShare>> slaveShares_;  // per thread: slave stations that it places
  std::vector<AlignedVector> tieWorkspaces_;        // per thread
  std::array<AlignedVector, 2> turningMoment_;      // of rim and body: what each station adds to -S
  double torque_ = 0, hubAngularVelocity_ = 0, addedAngularVelocity_ = 0;
};

}  // namespace squat::dynamics
