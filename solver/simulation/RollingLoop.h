// solver/simulation/RollingLoop.h - the time loop.
#pragma once

#include <chrono>

#include "core/Monitor.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

// Wall time of the rolling, without pauses.
class RunClock {
 public:
  double seconds() const;
  void leaveOut(std::chrono::steady_clock::duration pause) { start_ += pause; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

enum class LoopEnd { done, cancelled };

// Advances to `lastStep`, shows the state to the observers and asks the monitor whether to pause or to stop. What an
// observer throws ends the run.
LoopEnd roll(dynamics::Rolling& rolling, long lastStep, const Observers& observers, Monitor& monitor, RunClock& clock);

}  // namespace squat::simulation
