// solver/simulation/CheckpointWriter.h - keeps the state of a run on disk, so that it can be resumed.
#pragma once

#include <functional>
#include <string>

#include "simulation/RollingLoop.h"
#include "simulation/RunStart.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

struct CheckpointOptions {
  std::string path;      // empty: no checkpoints
  double seconds = 300;  // wall time between them
};

// The state of a run behind a step, with that of its observers and the figures of its start: what a checkpoint and a
// warm state hold. Throws RunError for a state that has diverged.
results::ArrayTree stateOf(const dynamics::Rolling& rolling, const RunStart& start, const Observers& observers,
                           const results::RunResult& result);

// Writes when the run starts, then whenever the time is over. Last in the list of observers: what it writes is the
// state of all of them behind the same step.
class CheckpointWriter : public StepObserver {
 public:
  // `warn` gets a text where a checkpoint cannot be written.
  CheckpointWriter(CheckpointOptions options, const RunStart& start, const Observers& observers,
                   const results::RunResult& result, const RunClock& clock,
                   std::function<void(const std::string&)> warn);

  void onStart(const dynamics::Rolling& rolling) override { write(rolling); }
  void onStep(const dynamics::Rolling& rolling) override;

  // A state that has diverged never replaces a good checkpoint (RunError). One that cannot be written is no reason
  // to lose the run: that is reported once, the earlier one stays, and the run continues.
  void write(const dynamics::Rolling& rolling);

 private:
  CheckpointOptions options_;
  RunStart start_;
  const Observers& observers_;
  const results::RunResult& result_;
  const RunClock& clock_;
  std::function<void(const std::string&)> warn_;
  double lastWritten_ = 0;  // [s] of the clock
  bool hasWarned_ = false;
};

}  // namespace squat::simulation
