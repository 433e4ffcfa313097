// solver/simulation/RunParts.h - pieces of runCase(): recording, guarding, describing. Internal to this folder.
#pragma once

#include <chrono>
#include <string>

#include "core/Monitor.h"
#include "dynamics/Rolling.h"
#include "dynamics/StableStep.h"
#include "results/ArrayTree.h"
#include "results/RunResult.h"
#include "signals/DecimatingFilter.h"
#include "simulation/EnergyLedger.h"
#include "statics/Equilibrium.h"

namespace squat::simulation {

double secondsSince(std::chrono::steady_clock::time_point start);

// Every signal on the solver's own steps, low-passed and thinned out to the output rate.
class Recorder {
 public:
  Recorder(double step, std::size_t stepsPerSample);
  void observe(const dynamics::StepView& view);
  void store(results::RunResult& result, double filterCutoff) const;
  double latestAxleBox() const { return filter_.latest(0); }
  double latestPosition() const;  // of the same instant
  double wait() const { return filter_.wait(); }
  void save(results::ArrayTree& tree) const;
  void load(const results::ArrayTree& tree, const std::string& file);

 private:
  signals::DecimatingFilter filter_;
};

// Throws RunError when the run has gone astray: not a number, runaway penetration, contact lost for good, books open,
// an element turned inside out.
class DivergenceGuard {
 public:
  // What a few numbers tell; after every few steps.
  void check(const dynamics::Rolling& rolling, const EnergyLedger& ledger);
  // What only all numbers and all elements tell; with each entry of the ledger, before each checkpoint, and for a state
  // that comes from a file.
  static void checkEverything(const dynamics::Rolling& rolling);
  // A run that goes on in the middle of a flight has not lost contact since the beginning of time.
  void goOnFrom(double time) { lastContact_ = time; }

 private:
  double lastContact_ = 0;  // [s]
};

// Equilibrium, Hertz, mesh and modes as they stand in the result.
void describeEquilibrium(const model::Model& model, const statics::Equilibrium& equilibrium,
                         results::RunResult& result);
void describeMesh(const model::Model& model, const dynamics::StableStep& stable, double step,
                  results::RunResult& result);
void describeModes(const cases::CaseDescription& description, results::RunResult& result);
void describeProfile(const cases::CaseDescription& description, results::RunResult& result);

// What plastic flow leaves behind: fields of the unloaded rail and their largest values. `unloaded`: state layout.
void describePermanentChange(const dynamics::Rolling& rolling, const AlignedVector& unloaded,
                             results::RunResult& result);

// PSD and scalogram of what has been recorded. Returns why there are none, or what to mind in them; else an empty text.
std::string addSpectra(const cases::CaseDescription& description, results::RunResult& result);

constexpr double mostStepsPerSample = 1e5;  // the filter before the samples keeps some twenty samples of them

// How a run was begun: found ahead of the rolling, kept in its checkpoints, so that nothing of it is done twice and the
// steps stay the same on another instruction set.
struct RunStart {
  long stepsPerSample = 0;
  double step = 0, beta = 0;  // [s]
};

// With the figures of mesh, equilibrium and modes. Loading throws FileError where they are missing or damaged, do not
// fit the output rate [Hz], or the checkpoint keeps its state in the order of another version.
void saveStart(const RunStart& start, const results::RunResult& result, results::ArrayTree& tree);
RunStart loadStart(const results::ArrayTree& tree, const std::string& file, double rate, results::RunResult& result);

// Snapshots and patches taken so far. Throws FileError where an array is missing or of a wrong type.
void savePictures(const results::RunResult& result, results::ArrayTree& tree);
void loadPictures(const results::ArrayTree& tree, const std::string& file, results::RunResult& result);

// The whole state of a rolling run as arrays, and back.
void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree);
dynamics::RollingState loadRolling(const results::ArrayTree& tree);

// Throws FileError(file, array) where a stored state has other arrays or lengths than this run, points of contact that
// the model does not have, or a step beyond the end: a checkpoint may come from a stranger.
void requireFittingState(const results::ArrayTree& tree, const dynamics::Rolling& rolling, long lastStep,
                         const std::string& file);

results::PatchSnapshot patchSnapshot(const std::string& name, const dynamics::Rolling& rolling);

}  // namespace squat::simulation
