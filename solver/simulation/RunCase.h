// solver/simulation/RunCase.h - the one way through: studio, command line, tests and studies enter here.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "case/CaseDeclaration.h"
#include "core/Monitor.h"
#include "results/RunResult.h"

namespace squat::dynamics {
class StepTimings;
}

namespace squat::simulation {

struct WarmState;  // WarmState.h

struct RunOptions {
  int threads = 0;                 // 0: all cores
  std::string isa;                 // empty: the best this processor has; else SweptKernel.h
  bool wheelsetModes = true;       // compute the natural modes of the half wheelset
  bool snapshots = true;           // keep fields for pictures
  std::string checkpointPath;      // empty: no checkpoints
  double checkpointSeconds = 300;  // wall time between checkpoints
  bool resume = false;             // resume from checkpointPath where it exists

  // Start from this state just before the defect, on its mesh; a checkpoint that is resumed comes first. The result is
  // that of the whole run on that mesh (WarmState.h: onMeshOf), to the bit.
  std::shared_ptr<const WarmState> warm;

  // Gets position [m] and axle box acceleration [m/s2] of every output sample as soon as its filter is complete, on the
  // computing thread; not those in the state from which the run resumes. Empty: not reported.
  std::function<void(double position, double acceleration)> sampled;

  // Gets the time of each phase and thread of the steps when the rolling ends. Empty: nothing is timed.
  std::function<void(const dynamics::StepTimings&)> timed;
};

// Case -> mesh -> model -> equilibrium -> rolling -> signals -> spectra. Returns also what a cancelled run has so far
// (complete == false, stopReason "cancelled"). A failed run throws RunError; what it has so far is handed to `partial`
// where one is given. Throws CaseError for a case that cannot be run, or not from options.warm. Never prints,
// aborts or exits.
results::RunResult runCase(const cases::CaseDescription& description, const RunOptions& options, Monitor& monitor,
                           results::RunResult* partial = nullptr);

}  // namespace squat::simulation
