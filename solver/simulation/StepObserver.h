// solver/simulation/StepObserver.h - who looks at a rolling run: signals, energy balance, guard, frames, progress.
//
// The loop (RollingLoop.h) advances to the nearest step that any observer asks for and shows the state to all of them,
// in their order. A new output is a new observer, never an edit of the loop.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/Rolling.h"
#include "results/ArrayTree.h"

namespace squat::simulation {

class StepObserver {
 public:
  static constexpr long never = std::numeric_limits<long>::max();

  virtual ~StepObserver() = default;

  // Number of steps done at which it wants to look next, beyond `done`.
  virtual long nextStep(long /*done*/) const { return never; }
  // Before the first step of a run that starts; a resumed run loads instead.
  virtual void onStart(const dynamics::Rolling&) {}
  // Each step, on the computing thread while others may already collect forces of the next: accelerations, contact and
  // velocities of unconstrained nodes may be read, nothing else. Has to be cheap.
  virtual void onEveryStep(const dynamics::Rolling&) {}
  // Between two steps; also at steps that other observers asked for.
  virtual void onStep(const dynamics::Rolling&) {}

  // Its part of a checkpoint. Loading throws FileError for what does not fit this run.
  virtual void save(results::ArrayTree&) const {}
  virtual void load(const results::ArrayTree&, const std::string& /*file*/) {}
};

using Observers = std::vector<StepObserver*>;

}  // namespace squat::simulation
