// solver/dynamics/SecondRolling.h - the bogie's other wheelset in time (model/SecondWheelset.h).
//
// Central differences with the step of the rolling: velocities stand half a step behind displacements. A pair of modes
// of harmonic n is seen from beside the track, Q, with its velocity P in axes that turn with it:
//   dQ/dt = P + w J Q,   dP/dt = F - omega^2 Q - 2 zeta omega dQ/dt + w J P,   w = (n - k) W,
// W the rate at which the wheelset turns, k the share of it that the pair stays behind (HarmonicMode::stays), J a
// quarter turn; the turning terms are applied as exact rotations. This is the wheelset of the rolling to first order in
// W / omega. Damping is that of the first wheelset's modes. On each side the sprung masses of both wheelsets are one
// rigid body that pitches: from its mass and pitch radius follows how much a force above one wheelset accelerates the
// body above the other.
#pragma once

#include <span>
#include <vector>

#include "model/Model.h"

namespace squat::dynamics {

// What a step shows of the second wheelset on one side.
struct SecondView {
  double boxAcceleration = 0;  // [m/s2] vertical, up positive
  double force = 0;            // [N] of the wheel on the rail, down positive
};

// [m/s] Of the parts of one side, half a step behind the displacements, up positive.
struct SecondVelocities {
  double wheel = 0, box = 0, sprung = 0;  // where the wheel touches; of the sprung mass above
};

class SecondRolling {
 public:
  // Models of all sides, left first; with the step of the time loop. Keeps references.
  SecondRolling(std::span<const model::Model* const> sides, double step);

  // All that changes while it rolls, for checkpoints.
  std::vector<double> packed() const;
  void unpack(std::span<const double> values);

  // Steady rolling over the rails' displacements and velocities at the start, in state layout of each side.
  void start(std::span<const double* const> displaced, std::span<const double* const> velocity);
  // Contact with the rails' displacements of this step; adds the forces to the force buffer of each side's model.
  void push(long step, std::span<const double* const> displaced, std::span<double* const> forces);
  // Advances by a step. `sprung` [N], per side: the force on the first wheelset's sprung mass without its weight, in
  // whose place comes what accelerates that part of the common body.
  void advance(std::span<double> sprung);

  const SecondView& view(std::size_t side) const { return views_[side]; }
  SecondVelocities velocities(std::size_t side) const;
  double placeAt(long step) const;  // [m] x of its wheels

  // [J] Sums over all sides. Kinetic energy of the present velocities, beyond what the first wheelset's sprung masses,
  // which move at `sprungVelocity` [m/s], have by themselves; modes and springs at the present displacements; contact
  // of the last push.
  double kineticEnergy(std::span<const double> sprungVelocity) const;
  double strainEnergy() const;
  double workOfWeight() const;
  double contactEnergy() const;
  // Since the start: taken by dampers; given by what turns the wheelset and moves it over slopes of the rail.
  double damped() const { return damped_; }
  double driven() const { return driven_; }

 private:
  // Cosine and sine of modes, or one motion and zero.
  struct Pair {
    double q[2] = {0, 0}, p[2] = {0, 0};
  };
  struct Motion {  // of one symmetry
    double rigid = 0, rigidVelocity = 0;
    std::vector<Pair> pairs;
  };
  struct Side {
    double sprung = 0, sprungVelocity = 0;
    double force = 0;       // [N] of the rail on the wheel, upwards, last push
    double suspension = 0;  // [N] on the axle box, upwards, last step
  };
  struct Mode {
    double omega2 = 0, damping = 0;  // [1/s2], [1/s] 2 zeta omega
    double contact = 0, box = 0;     // [1/sqrt(kg)] rise of the wheel where it touches, of the axle box
    double turn = 0;                 // [rad/s] w
    double cosine = 1, sine = 0;     // of a step's turn
  };
  struct Kind {
    double mass = 0, boxLever = 0;
    std::vector<Mode> modes;
  };
  // What a vector of all sides has in a symmetry, and back.
  double part(std::size_t kind, double left, double right) const;
  double sign(std::size_t kind, std::size_t side) const { return kind == 1 && side == 1 ? -1 : 1; }
  template <typename Of>
  double sumOver(std::size_t side, const Of& of) const;  // of(kind, motion), with its sign
  double wheel(std::size_t side) const;                  // [m] rise where it touches
  double box(std::size_t side) const;                    // [m]
  double wheelVelocity(std::size_t side) const;
  double boxVelocity(std::size_t side) const;
  double heightBelow(std::size_t side, double x, const double* displaced) const;
  void layHeights();
  void advanceMotion(std::size_t kind);

  std::vector<const model::Model*> models_;
  double step_, pitch_;  // [s]; (wheelbase / 2 / pitch radius)^2
  std::vector<Kind> kinds_;
  std::vector<model::SecondRailSeat> seats_;
  std::vector<std::vector<double>> heights_;  // [m] of the irregularity under the patch, from heightsFrom_ on
  double heightsFrom_ = 0;
  std::vector<Motion> motions_;
  std::vector<Side> sides_;
  std::vector<SecondView> views_;
  std::vector<double> boxBefore_;  // [m/s] velocities of the axle boxes
  double damped_ = 0, driven_ = 0;
};

}  // namespace squat::dynamics
