// solver/dynamics/Rolling.h - central difference of the rolling wheel on the track.
//
// One step, everything local in memory, two to four meetings of the threads: contact, force elements and torque collect
// forces on surface nodes, and tied nodes take the displacements of their masters; every thread reads what it needs
// beyond its stretches of stations; then each stretch computes its inner forces and is advanced at once, in place. The
// rim's tied nodes pass their inner forces to the wheel body, which follows. Who does what is in StepShares.h, how
// shares follow the machine in TeamPace.h. Ordered sums: the same bits for any number of threads and any shares.
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
//
// Two halves of one wheelset roll together (take()): each has its own rail, contact and forces; where sleepers and axle
// cross the track centre, both have the mean of their motion after each step, since the plane's nodes are one body of
// both masses. Both turn at one rate, by the moments and inertias of both.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/ThreadTeam.h"
#include "dynamics/ContactPhase.h"
#include "dynamics/RollingState.h"
#include "dynamics/SecondRolling.h"
#include "dynamics/StepShares.h"
#include "dynamics/StepTimings.h"
#include "dynamics/TeamPace.h"
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
  double boxLateralAcceleration = 0;                      // [m/s2] outwards, of a whole model
  double angularVelocity = 0;                             // [rad/s]
  SecondView second;                                      // of a bogie's other wheelset, this side
};

class Rolling {
 public:
  Rolling(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double step, double beta);
  Rolling(const Rolling&) = delete;
  Rolling& operator=(const Rolling&) = delete;
  ~Rolling();

  // Steady-rolling start: displacements of the equilibrium, velocities that rolling implies.
  void start(const AlignedVector& displacement, const AlignedVector& velocity, double angularVelocity);

  // Of a bogie, once all sides have started: its other wheelset rolls steadily as well.
  void startSecond();
  // Advances `steps` steps; `observe(view)` is called on the calling thread for every step.
  void advance(long steps, const std::function<void(const StepView&)>& observe);
  // From now on this half and the other one, which stays where it is, roll as one wheelset: every step of this one is
  // one of the other. Their models meet at the track centre (model/CentrePlane.h: shared) on meshes that are alike
  // there, with one step, one team and the same rotation. Throws std::invalid_argument where they do not.
  void take(Rolling& right);
  // The bogie's other wheelset; null: none, or the half has been taken by another, which has that of both.
  const SecondRolling* second() const { return second_.get(); }
  void restoreSecond(std::span<const double> packed) { second_->unpack(packed); }
  // This half and, where there is one, the one that it has taken.
  std::span<Rolling* const> sides() const { return sides_; }
  // Phases of each step and thread are timed from now on; null: no longer.
  void setTimings(StepTimings* timings) { timings_ = timings; }

  const RollingState& state() const { return state_; }
  const StepView& view() const { return view_; }  // of the last step
  void restore(RollingState state);
  const model::Model& model() const { return model_; }
  double stepSize() const { return step_; }
  double beta() const { return beta_; }
  const plasticity::LayerForces& layerForces() const { return layerForces_; }
  double wheelLoad() const { return load_; }
  double torqueAt(double time) const;
  ThreadTeam& team() const { return team_; }
  const elasticity::KernelSet& kernels() const { return kernels_; }
  // [kg] that closed points add, in the last step.
  double contactInertia() const { return contact_.inertia().addedMass(); }

  // Displacement u (state layout) with slaves and ghosts filled.
  AlignedVector displacement() const;
  void displacement(AlignedVector& filled) const;  // the same, without allocating
  // Contact points of the present state, for pictures; changes nothing.
  std::vector<contact::PatchPoint> patchPoints() const;
  // [m] x of the foremost contact point whose gap is below `margin` [m]; minus infinity where there is none.
  double frontOfContact(double margin) const;

 private:
  void takeSteps(int index, long first, long steps, const std::function<void(const StepView&)>& observe);
  void pushSides();     // every side's wheelset, with the angular acceleration of all
  void pushWheelset();  // contact, irregular elements, torque
  // What turns a side: moment, the part of the inner forces, inertia.
  struct Turning {
    double outer = 0, inner = 0, inertia = 0;
  };
  void pushLaterally();
  void pushSecond();
  void advanceSecond();
  void turn(const Turning& all);  // angular acceleration, and what the reference's own asks of each mass
  struct alignas(64) NextPiece {  // written by all threads, alone in its cache line
    std::atomic<std::size_t> at{0};
  };
  void addContactInertia(int body);
  void pushForceElements(int index);
  void sumDamperPower();
  void placeTiedNodes(const ThreadShare& own, int index);
  void yieldLayer(int index, int threads, long step);
  void readEnds(ThreadShare& own, int index, bool late);
  void advanceStations(const ThreadShare& own, int index);  // and what is tied to nothing
  void passTieForces(const ThreadShare& own, int index);
  void advanceMasters(const ThreadShare& own, int index);
  void advanceSleepers(int index);
  void advanceSleeper(SleeperShare& sleeper, int index);
  void joinAxle(const ThreadShare& own);  // the part of the axle's centre that the thread has advanced, of both sides
  void joinSleepers(const SleeperShare& sleeper);
  void finishStep();
  void finishSides();
  void dampWheelset();
  void dampBothHalves();
  void takeAccelerations();
  void fix(const std::vector<std::size_t>& unknowns);
  void evaluateContact();
  void applyHubForce();
  model::PlaneVector boxVelocity() const;
  double boxLateralVelocity() const;
  contact::WheelRolling wheelRolling(const double* displaced) const;
  double positionOf(const contact::WheelRolling& wheel) const;

  const model::Model& model_;
  elasticity::KernelSet kernels_, askedKernels_;  // the latter in the precision that the case asks for
  ThreadTeam& team_;
  StepTimings* timings_ = nullptr;
  double step_, beta_, load_;
  ContactPhase contact_;
  RollingState state_;
  AlignedVector forces_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  std::vector<elasticity::BlockStep> blockSteps_;
  model::WheelsetDamping wheelsetDamping_;
  std::vector<Rolling*> sides_{this};
  struct Halves;  // what both of a whole wheelset need together
  std::unique_ptr<Halves> halves_;
  std::unique_ptr<SecondRolling> second_;
  TeamPace pace_;
  StepShares shares_, oneShare_;             // of all threads; of one that works alone
  StepShares* taken_ = nullptr;              // those of the steps that are being made
  NextPiece nextForces_, nextSleeper_;       // of trackForces and of the sleepers
  std::vector<AlignedVector> acceleration_;  // per block: 3 lines
  std::vector<AlignedVector> inverseMass_;   // per block, in chunks
  std::vector<std::vector<double>> evenInverse_;
  std::vector<std::vector<double>> radii_;  // per block: of section nodes, around the axis
  model::TurnedStations turned_, turnedRim_;
  plasticity::LayerKernels layerKernels_;
  plasticity::LayerForces layerForces_;
  StepView view_;
  model::PlaneVector boxVelocity_, wheelVelocity_;
  double boxLateralVelocity_ = 0;  // [m/s]
  double angularAcceleration_ = 0, referenceAcceleration_ = 0;
  double damperPower_ = 0;                      // [W]
  std::vector<double> groupDamperPowers_;       // [W] of each group of force elements, written while they push
  std::vector<AlignedVector> tieWorkspaces_;    // per thread
  std::array<AlignedVector, 2> turningMoment_;  // of rim and body: what each station adds to -S
  double torque_ = 0, hubAngularVelocity_ = 0, addedAngularVelocity_ = 0;
};

}  // namespace squat::dynamics
