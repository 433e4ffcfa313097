// solver/simulation/DivergenceGuard.h - stops a run that has diverged.
#pragma once

#include "simulation/EnergyBalance.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

// No wheel turns further on the longest track, or faster at the highest speed, even where it slips.
constexpr double maximumRotation = 1e4, maximumAngularVelocity = 1e5;  // [rad], [rad/s]

// Throws RunError for a value that is not a number, runaway penetration, contact lost for good, an energy balance that
// does not close, an element turned inside out. The error names the place of the largest value: a node of the mesh, or
// a part of a bogie's second wheelset, with x [m] from the deepest point of the defect.
class DivergenceGuard : public StepObserver {
 public:
  // Looks at every `grid`-th step of a sample of `perSample` steps; at all numbers and elements at the steps of the
  // energy balance. A run that resumes in mid-air has not lost contact since the beginning of time.
  DivergenceGuard(const dynamics::Rolling& rolling, const EnergyBalance& balance, long perSample, long grid);

  long nextStep(long done) const override;
  void onStep(const dynamics::Rolling& rolling) override;

  // What only all numbers and all elements show; also before each checkpoint and for a state that comes from a file.
  static void checkEverything(const dynamics::Rolling& rolling);

 private:
  static void checkEverything(const dynamics::Rolling& rolling, AlignedVector& displacement);
  // Of the halves that the first one rolls with, itself among them.
  static void checkSide(const dynamics::Rolling& first, std::size_t side, AlignedVector& displacement);
  void check(const dynamics::Rolling& first, std::size_t side);

  const EnergyBalance& balance_;
  long perSample_, grid_, firstStep_;
  std::size_t entries_ = 0;
  std::vector<double> lastContact_;  // [s] of each side
  AlignedVector displacement_;       // kept: allocating it each time costs more than filling it
};

}  // namespace squat::simulation
