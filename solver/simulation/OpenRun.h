// solver/simulation/OpenRun.h - a run under way: what it carries from phase to phase, from the case to the first step.
// runCase, makeWarmState and the wheelsets of solver/growth walk the same way; others call those.
#pragma once

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/Resolve.h"
#include "dynamics/StableStep.h"
#include "model/Model.h"
#include "simulation/CheckpointWriter.h"
#include "simulation/DivergenceGuard.h"
#include "simulation/EnergyObserver.h"
#include "simulation/FieldRecorder.h"
#include "simulation/ProgressReporter.h"
#include "simulation/RunCase.h"
#include "simulation/SampleStream.h"
#include "simulation/SignalRecorder.h"
#include "statics/SteadyRollingStart.h"

namespace squat::simulation {

using Clock = std::chrono::steady_clock;
inline double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Everything that looks at the rolling, in the order in which it looks.
class RollingRun {
 public:
  // `lastStep`: the end that progress counts to. `warn` as CheckpointWriter's.
  RollingRun(const RunOptions& options, results::RunResult& result, Monitor& monitor, dynamics::Rolling& rolling,
             const ModelFields* fields, const RunStart& start, double startStrain, long lastStep,
             std::function<void(const std::string&)> warn);
  RollingRun(const RollingRun&) = delete;
  RollingRun& operator=(const RollingRun&) = delete;

  EnergyBalance balance;
  RunClock clock;
  SignalRecorder recorder;
  EnergyObserver energy;
  DivergenceGuard guard;
  std::optional<FieldRecorder> frames;
  std::optional<SampleStream> stream;
  long firstStep, lastStep;
  ProgressReporter progress;
  CheckpointWriter checkpoint;
  Observers observers;
};

// Validates the case (CaseError), then builds and starts what rolls. Members stand in the order in which they are made.
class OpenRun {
 public:
  OpenRun(const cases::CaseDescription& description, const RunOptions& options, Monitor& monitor);
  OpenRun(const OpenRun&) = delete;
  OpenRun& operator=(const OpenRun&) = delete;

  // Mesh, equilibrium and start, or the same from a stored state, which FileError refuses where it does not fit. False
  // where it was cancelled.
  bool start(const StoredState* stored);
  // Makes the observers; `rolledTo`: the step that progress counts to, 0: the last one of the run.
  void observe(const StoredState* stored, long rolledTo = 0);

  template <typename Phase>
  auto timed(const char* name, const Phase& phase) {
    const auto begun = Clock::now();
    reportPhase(name);
    auto value = phase();
    phases.push_back({std::string("seconds_") + name, "s", "wall time", secondsSince(begun)});
    return value;
  }
  void warn(const std::string& text);
  long samples() const;  // of the whole run
  // The filter of the signals waits for what comes behind the last sample.
  long lastStep() const;

  const Clock::time_point opened = Clock::now();
  const cases::CaseDescription& description;
  const cases::Sides sides;
  const scenario::Scenario& scenario;  // of the left side, or the half model
  const RunOptions& options;
  Monitor& monitor;
  results::RunResult result;
  std::vector<results::Scalar> phases;
  elasticity::KernelSet kernels;
  std::unique_ptr<ThreadTeam> team;
  model::Model model;
  std::optional<model::Model> rightModel;  // of a whole model
  RunStart steps;
  std::unique_ptr<ModelFields> fields;
  std::optional<dynamics::StepTimings> timings;  // where they are asked for
  std::optional<dynamics::Rolling> rolling, rightRolling;
  std::optional<RollingRun> parts;

 private:
  void refuseOrWarn();
  void identify();
  void reportPhase(const char* name);
  using Modes = std::vector<results::WheelsetMode>;
  bool begin(std::future<Modes> modes);
  dynamics::StableStep findStableStep();
  std::vector<statics::SteadyRollingStart> findStart();  // of each side
  void warnOfLateralShift(const statics::Equilibrium& left, const statics::Equilibrium& right);
  void makeRolling();
  void restore(const StoredState& stored);
  double startStrain_ = 0;  // [J]
};

}  // namespace squat::simulation
