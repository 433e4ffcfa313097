// solver/simulation/EnergyBalance.h - where the energy is, where it went, and whether the balance closes.
//
// Kinetic energy counts from that of the reference motion (constant), at full steps as the mean of both half steps; so
// does what dashpots and torque have done: half the work of a step is done when its displacement stands. The residual
// is change of kinetic, strain and contact energy plus everything dissipated minus the work of torque and weight; it is
// judged against the strain energy at the start plus all dissipation. Of a whole wheelset everything is that of both
// sides: each alone gets and gives energy at the track centre. A bogie's second wheelset counts in the sums.
#pragma once

#include <vector>

#include "dynamics/Rolling.h"
#include "results/RunResult.h"
#include "simulation/EnergySums.h"

namespace squat::simulation {

class EnergyBalance {
 public:
  EnergyBalance(const dynamics::Rolling& rolling, double startStrain);

  // Call before a step and right after it; the sample belongs to the displacement before the step.
  void before(const dynamics::Rolling& rolling);
  void after(const dynamics::Rolling& rolling);

  double relativeResidual() const;         // of the last sample
  double largestRelativeResidual() const;  // so far
  std::size_t entries() const { return samples_.size(); }
  std::vector<double> times() const { return time_; }
  std::vector<results::Channel> channels() const;

  // Strain energy by solid and spring set at the last sample, for the table at the end.
  struct Shares {
    double rail = 0, wheelset = 0, sleepers = 0, springs = 0;
  };
  Shares shares() const { return shares_; }
  void setShares(const Shares& shares) { shares_ = shares; }

  // For checkpoints: everything as rows of numbers, an entry begun by before() included. isPacked: of a right length.
  std::vector<double> pack() const;
  static bool isPacked(const std::vector<double>& numbers);
  void unpack(const std::vector<double>& numbers);

 private:
  struct Sample {
    double kinetic = 0, strain = 0, contact = 0, friction = 0, damping = 0, external = 0, plastic = 0;
  };
  double kineticEnergy(const dynamics::Rolling& rolling);  // of all sides
  double kineticEnergy(const dynamics::Rolling& side, EnergySums& sums) const;
  void addSums(const dynamics::Rolling& rolling);
  double residual(const Sample& sample) const;  // [J]
  double relativeResidual(const Sample& sample) const;
  double reference_ = 0;  // [J] strain energy at the start
  double firstAngularVelocity_ = 0;
  double materialDamping_ = 0, lastDampingPower_ = 0, lastTime_ = 0;
  Sample first_, pending_;
  bool started_ = false;
  Shares shares_;
  std::vector<double> time_;
  std::vector<Sample> samples_;
  std::vector<EnergySums> sums_;           // of each side
  AlignedVector displacement_, velocity_;  // kept: allocating them costs more than filling them
};

}  // namespace squat::simulation
