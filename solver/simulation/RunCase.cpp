#include "simulation/RunCase.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "analysis/FeatureTable.h"
#include "core/Errors.h"
#include "core/platform/Memory.h"
#include "results/Checkpoint.h"
#include "signals/SignalCatalogue.h"
#include "simulation/Describe.h"
#include "simulation/OpenRun.h"
#include "simulation/WarmState.h"
#include "statics/UnloadedShape.h"

namespace squat::simulation {

namespace {

// True when it ran to its end, false when cancelled.
bool rollToTheEnd(OpenRun& run) {
  auto& rolling = *run.rolling;
  auto& parts = *run.parts;
  DivergenceGuard::checkEverything(rolling);
  const bool complete = roll(rolling, parts.lastStep, parts.observers, run.monitor, parts.clock) == LoopEnd::done;
  if (run.timings) run.options.timed(*run.timings);
  // Unloading of a rail that yields follows, and can be cancelled too.
  if (!complete || !rolling.model().layer.empty()) parts.checkpoint.write(rolling);
  return complete;
}

void store(OpenRun& run) {
  auto& r = run.result;
  const auto& parts = *run.parts;
  const auto& rolling = *run.rolling;
  parts.recorder.store(r, static_cast<std::size_t>(run.samples()), run.scenario.output.filterCutoff);
  r.energyTime = parts.balance.times();
  r.energy = parts.balance.channels();
  const auto shares = parts.balance.shares();
  r.equilibrium.push_back({"strain_energy_rail", "J", "at the end", shares.rail});
  r.equilibrium.push_back({"strain_energy_wheelset", "J", "at the end", shares.wheelset});
  r.equilibrium.push_back({"strain_energy_sleepers", "J", "at the end", shares.sleepers});
  r.equilibrium.push_back({"strain_energy_springs", "J", "at the end", shares.springs});
  const auto steps = static_cast<double>(rolling.state().step - parts.firstStep);
  const double seconds = parts.clock.seconds();
  r.performance.push_back({"steps", "1", "", static_cast<double>(rolling.state().step)});
  r.performance.push_back({"rolling_seconds", "s", "wall time", seconds});
  double elements = 0;
  for (const auto* side : rolling.sides()) elements += static_cast<double>(side->model().elements());
  r.performance.push_back({"element_updates_per_second", "1/s", "elements times steps over wall time of the rolling",
                           steps * elements / seconds});
  r.performance.push_back({"energy_residual", "1", "largest, of strain energy at the start plus all dissipation",
                           parts.balance.largestRelativeResidual()});
}

void warnOfOtherProcessor(OpenRun& run, const results::ArrayTree& tree, const std::string& what) {
  if (const auto isa = results::textAttribute(tree.attributes, "isa"); isa != run.result.isa)
    run.warn("resumed on " + run.result.isa + " " + what + " " + isa +
             ": results may differ in the last digits from an uninterrupted run");
}

std::optional<results::ArrayTree> readMatchingCheckpoint(OpenRun& run) {
  if (!run.options.resume || run.options.checkpointPath.empty()) return {};
  bool usedPrevious = false;
  auto tree = results::readCheckpoint(run.options.checkpointPath, &usedPrevious);
  if (!tree) return {};
  const auto hash = results::textAttribute(tree->attributes, "case_hash");
  if (hash != run.result.caseHash)
    throw CaseError({{"--resume", run.options.checkpointPath, "a checkpoint of this case (" + run.result.caseHash + ")",
                      "It belongs to case " + hash + ": give another output folder or run without --resume"}});
  warnOfOtherProcessor(run, *tree, "a run that was begun on");
  if (usedPrevious)
    run.monitor.message("warning: the newest checkpoint is not whole; the run resumes from the one before");
  return tree;
}

// Beyond this creepage friction is exhausted everywhere in a patch of this size, many times over.
constexpr double slipping = 0.01;

void markRotation(OpenRun& run, double radius) {
  auto& r = run.result;
  const auto* angularVelocity = r.signal(signals::names::wheelSpeed);
  if (!angularVelocity) return;
  double maximum = 0;
  for (const double rate : *angularVelocity)
    if (std::abs(rate * radius / r.speed - 1) > std::abs(maximum)) maximum = rate * radius / r.speed - 1;
  r.equilibrium.push_back({"largest_creepage", "1", "angular velocity times radius over speed, less one", maximum});
  if (std::abs(maximum) < slipping) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "the wheel slips: its circumference moves %.1f %% %s than the train; reduce the torque",
                100 * std::abs(maximum), maximum > 0 ? "faster" : "slower");
  run.warn(text);
}

// The rail without the wheel: what plastic flow has left. False where it was cancelled.
bool unload(OpenRun& run) {
  const auto& rolling = *run.rolling;
  const auto shape =
      statics::findUnloadedShape(rolling.model(), rolling.kernels(), *run.team, rolling.layerForces(), run.monitor);
  if (shape.cancelled) return false;
  describePermanentChange(rolling, shape.displacement, run.result);
  if (run.fields)
    run.result.snapshots.push_back(
        run.fields->snapshot("unloaded", {{shape.displacement, rolling.state().plastic}}, rolling.state().time,
                             rolling.view().position - rolling.model().startX, rolling.state().rotation, true));
  return true;
}

void finish(OpenRun& run) {
  auto& r = run.result;
  const std::string lacking = addSpectra(run.scenario, r);
  if (r.complete && !lacking.empty()) run.warn(lacking);  // a part of a run has seldom enough
  r.features = analysis::featureScalars(r);
  r.performance.push_back({"seconds", "s", "wall time of the whole run", secondsSince(run.opened)});
  r.performance.push_back({"peak_memory", "B", "largest resident size", platform::peakMemory()});
  r.performance.insert(r.performance.end(), run.phases.begin(), run.phases.end());
}

void rollAndStore(OpenRun& run, results::RunResult* partial) {
  try {
    bool complete = run.timed("rolling", [&] { return rollToTheEnd(run); });
    store(run);
    markRotation(run, run.model.surfaces.radius);
    if (complete && !run.model.layer.empty()) complete = run.timed("unloading", [&] { return unload(run); });
    run.result.complete = complete;
    run.result.stopReason = complete ? "done" : "cancelled";
    run.timed("spectra", [&] { return finish(run), 0; });
  } catch (const RunError& error) {
    if (run.result.time.empty()) store(run);
    run.result.stopReason = std::string("failed: ") + error.what();
    finish(run);
    if (partial) *partial = run.result;
    throw;
  }
}

}  // namespace

results::RunResult runCase(const cases::CaseDescription& description, const RunOptions& options, Monitor& monitor,
                           results::RunResult* partial) {
  if (options.warm) requireFit(*options.warm, description);
  const auto meshed = options.warm ? onMeshOf(*options.warm, description) : description;
  OpenRun run(meshed, options, monitor);
  const auto checkpoint = readMatchingCheckpoint(run);
  std::optional<StoredState> stored;
  if (checkpoint) {
    stored.emplace(StoredState{*checkpoint, options.checkpointPath, "start the run again without --resume"});
  } else if (options.warm) {
    stored.emplace(storedIn(*options.warm));
    warnOfOtherProcessor(run, stored->tree, "from a warm state of");
  }
  const StoredState* from = stored ? &*stored : nullptr;
  if (!run.start(from)) return run.result;
  if (from && !checkpoint) requireAhead(*options.warm, *run.rolling);
  run.observe(from);
  rollAndStore(run, partial);
  return run.result;
}

}  // namespace squat::simulation
