// solver/simulation/ProgressReporter.h - what is seen of a run while it rolls: progress, remaining time, live curves.
#pragma once

#include "core/Monitor.h"
#include "simulation/EnergyBalance.h"
#include "simulation/RollingLoop.h"
#include "simulation/SignalRecorder.h"

namespace squat::simulation {

// Reports ten times a second and at the end.
class ProgressReporter : public StepObserver {
 public:
  ProgressReporter(const dynamics::Rolling& rolling, long lastStep, const SignalRecorder& signals,
                   const EnergyBalance& balance, const RunClock& clock, Monitor& monitor);
  void onStep(const dynamics::Rolling& rolling) override;

 private:
  long firstStep_, lastStep_;
  const SignalRecorder& signals_;
  const EnergyBalance& balance_;
  const RunClock& clock_;
  Monitor& monitor_;
  double lastReport_ = -1;  // [s] of the clock
};

}  // namespace squat::simulation
