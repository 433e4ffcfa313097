#include "simulation/RunCase.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>
#include <utility>

#include "case/CaseFile.h"
#include "case/MeshPresets.h"
#include "case/Resolve.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "simulation/CheckpointWriter.h"
#include "simulation/Describe.h"
#include "simulation/DivergenceGuard.h"
#include "simulation/EnergyObserver.h"
#include "simulation/FieldRecorder.h"
#include "simulation/ProgressReporter.h"
#include "simulation/RollingLoop.h"
#include "simulation/RollingStateFile.h"
#include "simulation/RunStart.h"
#include "simulation/SignalRecorder.h"
#include "simulation/SurfaceFields.h"
#include "statics/QuietStart.h"
#include "statics/UnloadedShape.h"

#ifndef SQUAT_VERSION
#define SQUAT_VERSION "unknown"
#endif

namespace squat::simulation {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr long maximumStepsAtOnce = 24;  // cancel is asked at least this often
constexpr int samplesPerLedger = 5;      // output samples between entries of the energy balance

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

// Everything that one run carries from phase to phase.
struct Run {
  const cases::CaseDescription& description;
  const scenario::Scenario& scenario;
  const RunOptions& options;
  Monitor& monitor;
  results::RunResult result;
  std::vector<results::Scalar> phases;

  template <typename Phase>
  auto timed(const char* name, const Phase& phase) {
    const auto start = Clock::now();
    Progress begun;
    begun.phase = name;
    std::replace(begun.phase.begin(), begun.phase.end(), '_', ' ');
    monitor.report(begun);
    auto value = phase();
    phases.push_back({std::string("seconds_") + name, "s", "wall time", secondsSince(start)});
    return value;
  }

  void tellStep(double step, const std::string& place) {
    Progress progress;
    progress.phase = "stable step";
    progress.fraction = 1;
    progress.step = step;
    progress.limitedBy = place;
    monitor.report(progress);
  }
};

void warn(Run& run, const std::string& text) {
  run.result.warnings.push_back(text);
  run.monitor.message("warning: " + text);
}

void refuseOrWarn(Run& run) {
  const auto validation = cases::validate(run.description);
  if (!validation.problems.empty()) throw CaseError(validation.problems);
  for (const auto& warning : validation.warnings) warn(run, toWarning(warning));
  if (const std::string note = cases::presetNote(run.description); !note.empty()) warn(run, note);
}

void identify(Run& run, const elasticity::KernelSet& kernels, int threads) {
  auto& r = run.result;
  r.title = run.description.title;
  results::setCase(r, run.description);
  r.codeVersion = SQUAT_VERSION;
  r.isa = kernels.name;
  r.threads = threads;
  r.created = utcNow();
  r.speed = run.scenario.motion.speed;
  r.stopReason = "cancelled";
}

// Steps per output sample: the stable step, or the user's where it is shorter.
long stepsPerSample(const scenario::Scenario& d, const dynamics::StableStep& stable) {
  const double sample = 1 / d.output.rate;
  if (d.output.timeStep > stable.step)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at most " + std::to_string(stable.step * 1e6) + " us: the stable step of this mesh",
                      "Leave it at 0 for the stable step; it is set by " + stable.place}});
  const double wished = d.output.timeStep > 0 ? d.output.timeStep : stable.step;
  if (sample / wished > maximumStepsPerSample)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at least " + std::to_string(sample / maximumStepsPerSample * 1e6) + " us",
                      "Leave it at 0 for the stable step; it is set by " + stable.place}});
  return std::max(2L, static_cast<long>(std::ceil(sample / wished - 1e-9)));
}

long samplesOf(const scenario::Scenario& d) {
  return static_cast<long>(std::floor((d.motion.runUp + d.motion.beyond) / d.motion.speed * d.output.rate)) + 1;
}

// The filter of the signals waits for what comes behind the last sample.
long lastStepOf(const scenario::Scenario& d, const dynamics::Rolling& rolling, const RunStart& start) {
  const SignalRecorder recorder(rolling, static_cast<std::size_t>(start.stepsPerSample));
  return samplesOf(d) * start.stepsPerSample + static_cast<long>(std::ceil(recorder.wait() / rolling.stepSize()));
}

// Everything that looks at the rolling, in the order in which it looks.
struct RollingRun {
  RollingRun(Run& run, dynamics::Rolling& rolling, const SurfaceFields* fields, const RunStart& start,
             double startStrain)
      : ledger(rolling, startStrain),
        recorder(rolling, static_cast<std::size_t>(start.stepsPerSample)),
        energy(ledger, samplesPerLedger * start.stepsPerSample),
        guard(rolling, ledger, start.stepsPerSample, maximumStepsAtOnce),
        firstStep(rolling.state().step),
        lastStep(lastStepOf(run.scenario, rolling, start)),
        progress(rolling, lastStep, recorder, ledger, clock, run.monitor),
        checkpoint({run.options.checkpointPath, run.options.checkpointSeconds}, start, observers, run.result, clock,
                   [&run](const std::string& text) { warn(run, text); }) {
    observers = {&recorder, &energy, &guard};
    if (fields) observers.push_back(&frames.emplace(*fields, run.result, start.stepsPerSample, maximumStepsAtOnce));
    observers.insert(observers.end(), {&progress, &checkpoint});
  }
  RollingRun(const RollingRun&) = delete;
  RollingRun& operator=(const RollingRun&) = delete;

  EnergyLedger ledger;
  RunClock clock;
  SignalRecorder recorder;
  EnergyObserver energy;
  DivergenceGuard guard;
  std::optional<FieldRecorder> frames;
  long firstStep, lastStep;
  ProgressReporter progress;
  CheckpointWriter checkpoint;
  Observers observers;
};

// True when it ran to its end, false when cancelled.
bool rollToTheEnd(Run& run, dynamics::Rolling& rolling, RollingRun& parts) {
  DivergenceGuard::checkEverything(rolling);
  const bool complete = roll(rolling, parts.lastStep, parts.observers, run.monitor, parts.clock) == LoopEnd::done;
  // Unloading of a rail that yields follows, and can be cancelled too.
  if (!complete || !rolling.model().layer.empty()) parts.checkpoint.write(rolling);
  return complete;
}

void store(Run& run, const dynamics::Rolling& rolling, const RollingRun& parts) {
  auto& r = run.result;
  parts.recorder.store(r, static_cast<std::size_t>(samplesOf(run.scenario)), run.scenario.output.filterCutoff);
  r.energyTime = parts.ledger.times();
  r.energy = parts.ledger.channels();
  const auto shares = parts.ledger.shares();
  r.equilibrium.push_back({"strain_energy_rail", "J", "at the end", shares.rail});
  r.equilibrium.push_back({"strain_energy_wheelset", "J", "at the end", shares.wheelset});
  r.equilibrium.push_back({"strain_energy_sleepers", "J", "at the end", shares.sleepers});
  r.equilibrium.push_back({"strain_energy_springs", "J", "at the end", shares.springs});
  const auto steps = static_cast<double>(rolling.state().step - parts.firstStep);
  const double seconds = parts.clock.seconds();
  r.performance.push_back({"steps", "1", "", static_cast<double>(rolling.state().step)});
  r.performance.push_back({"rolling_seconds", "s", "wall time", seconds});
  r.performance.push_back({"element_updates_per_second", "1/s", "elements times steps over wall time of the rolling",
                           steps * static_cast<double>(rolling.model().elements()) / seconds});
  r.performance.push_back({"energy_residual", "1", "largest, of strain energy at the start plus all dissipation",
                           parts.ledger.largestRelativeResidual()});
}

// Resumes from a checkpoint. Throws FileError for one that does not fit this run, before anything is taken from it.
void restore(Run& run, dynamics::Rolling& rolling, const RunStart& start, const results::ArrayTree& tree) {
  const auto& file = run.options.checkpointPath;
  requireFittingState(tree, rolling, lastStepOf(run.scenario, rolling, start), file);
  rolling.restore(loadRolling(tree));
  loadPictures(tree, file, run.result);
}

std::optional<results::ArrayTree> readMatchingCheckpoint(Run& run) {
  if (!run.options.resume || run.options.checkpointPath.empty()) return {};
  bool usedPrevious = false;
  auto tree = results::readCheckpoint(run.options.checkpointPath, &usedPrevious);
  if (!tree) return {};
  const auto hash = results::textAttribute(tree->attributes, "case_hash");
  if (hash != run.result.caseHash)
    throw CaseError({{"--resume", run.options.checkpointPath, "a checkpoint of this case (" + run.result.caseHash + ")",
                      "It belongs to case " + hash + ": give another output folder or run without --resume"}});
  const auto isa = results::textAttribute(tree->attributes, "isa");
  if (isa != run.result.isa)
    warn(run, "resumed on " + run.result.isa + " a run that was begun on " + isa +
                  ": results may differ in the last digits from an uninterrupted run");
  if (usedPrevious) run.monitor.message("warning: the newest checkpoint is not whole; going on from the one before");
  return tree;
}

// Beyond this creepage friction is exhausted everywhere in a patch of this size, many times over.
constexpr double spinning = 0.01;

void markSpin(Run& run, double radius) {
  auto& r = run.result;
  const auto* spin = r.signal("wheel_speed");
  if (!spin) return;
  double most = 0;
  for (const double rate : *spin)
    if (std::abs(rate * radius / r.speed - 1) > std::abs(most)) most = rate * radius / r.speed - 1;
  r.equilibrium.push_back({"largest_creepage", "1", "spin times radius over speed, less one", most});
  if (std::abs(most) < spinning) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "the wheel slips: its circumference moves %.1f %% %s than the train; reduce the torque",
                100 * std::abs(most), most > 0 ? "faster" : "slower");
  r.warnings.push_back(text);
  run.monitor.message(std::string("warning: ") + text);
}

// Everything ahead of the rolling. A checkpoint holds what comes of it, so a resumed run has `steps` alone.
struct Beginning {
  RunStart steps;
  statics::QuietStart quiet;
  bool cancelled = false;
};

Beginning begin(Run& run, const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team) {
  const auto& d = run.scenario;
  if (run.monitor.cancelled()) return {{}, {}, true};
  if (run.options.wheelsetModes) run.timed("modes", [&] { return describeModes(d, run.result), 0; });
  if (run.monitor.cancelled()) return {{}, {}, true};
  const auto stable = run.timed("stable_step", [&] { return dynamics::stableStep(model, kernels, team, run.monitor); });
  if (run.monitor.cancelled()) return {{}, {}, true};
  Beginning beginning;
  const long perSample = stepsPerSample(d, stable);
  beginning.steps = {perSample, 1 / d.output.rate / static_cast<double>(perSample), stable.beta};
  describeMesh(model, stable, beginning.steps.step, run.result);
  run.tellStep(beginning.steps.step, stable.place);
  beginning.quiet =
      run.timed("equilibrium", [&] { return statics::prepareQuietStart(model, kernels, team, run.monitor); });
  beginning.cancelled = beginning.quiet.equilibrium.cancelled;
  if (!beginning.cancelled) describeEquilibrium(model, beginning.quiet.equilibrium, run.result);
  return beginning;
}

// The rail without the wheel: what plastic flow has left. False where it was cancelled.
bool unload(Run& run, const dynamics::Rolling& rolling, ThreadTeam& team, const SurfaceFields* fields) {
  const auto shape =
      statics::findUnloadedShape(rolling.model(), rolling.kernels(), team, rolling.layerForces(), run.monitor);
  if (shape.cancelled) return false;
  describePermanentChange(rolling, shape.displacement, run.result);
  if (fields)
    run.result.snapshots.push_back(fields->snapshot("unloaded", shape.displacement, rolling.state().time,
                                                    rolling.view().position - rolling.model().startX,
                                                    rolling.state().rotation, rolling.state().plastic, true));
  return true;
}

void finish(Run& run, Clock::time_point start) {
  auto& r = run.result;
  const std::string lacking = addSpectra(run.scenario, r);
  if (r.complete && !lacking.empty()) warn(run, lacking);  // a part of a run has seldom enough
  r.performance.push_back({"seconds", "s", "wall time of the whole run", secondsSince(start)});
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  r.performance.push_back({"peak_memory", "B", "largest resident size", 1024.0 * static_cast<double>(usage.ru_maxrss)});
  r.performance.insert(r.performance.end(), run.phases.begin(), run.phases.end());
}

}  // namespace

results::RunResult runCase(const cases::CaseDescription& description, const RunOptions& options, Monitor& monitor,
                           results::RunResult* partial) {
  const auto start = Clock::now();
  const scenario::Scenario scenario = cases::resolve(description);
  Run run{description, scenario, options, monitor, {}, {}};
  refuseOrWarn(run);
  elasticity::KernelSet kernels;
  try {
    kernels = elasticity::kernelsFor(options.isa);
  } catch (const std::invalid_argument& error) {
    throw CaseError({{"--isa", options.isa, "one that this processor has", error.what()}});
  }
  ThreadTeam team(threadCount(options.threads));
  identify(run, kernels, team.size());
  const auto checkpoint = readMatchingCheckpoint(run);

  const model::Model model = run.timed("mesh", [&] { return model::buildModel(scenario); });
  if (scenario.rail.plastic && model.layer.empty())
    warn(run,
         "rail.plastic_depth is less than half an element of the head: no element can yield, the rail stays elastic");
  describeProfile(scenario, run.result);
  Beginning beginning;
  if (checkpoint)
    beginning.steps = loadStart(*checkpoint, options.checkpointPath, scenario.output.rate, run.result);
  else
    beginning = begin(run, model, kernels, team);
  if (beginning.cancelled) return run.result;

  std::unique_ptr<SurfaceFields> fields;
  if (options.snapshots) {
    fields = std::make_unique<SurfaceFields>(model);
    run.result.surface = fields->mesh();
  }
  dynamics::Rolling rolling(model, kernels, team, beginning.steps.step, beginning.steps.beta);
  const auto& motion = scenario.motion;
  const auto& displacement = beginning.quiet.equilibrium.displacement;
  if (checkpoint)
    rolling.start(AlignedVector(model.stateSize, 0.0), AlignedVector(model.stateSize, 0.0), 0);
  else
    rolling.start(displacement, beginning.quiet.velocity,
                  motion.angularVelocity > 0 ? motion.angularVelocity : motion.speed / model.surfaces.radius);
  if (fields && !checkpoint)
    run.result.snapshots.push_back(fields->snapshot("equilibrium", displacement, 0, 0, 0, rolling.state().plastic));

  if (checkpoint) restore(run, rolling, beginning.steps, *checkpoint);
  RollingRun parts(run, rolling, fields.get(), beginning.steps, beginning.quiet.equilibrium.strainEnergy);
  if (checkpoint)
    for (auto* observer : parts.observers) observer->load(*checkpoint, options.checkpointPath);
  try {
    bool complete = run.timed("rolling", [&] { return rollToTheEnd(run, rolling, parts); });
    store(run, rolling, parts);
    markSpin(run, model.surfaces.radius);
    if (complete && !model.layer.empty())
      complete = run.timed("unloading", [&] { return unload(run, rolling, team, fields.get()); });
    run.result.complete = complete;
    run.result.stopReason = complete ? "done" : "cancelled";
    run.timed("spectra", [&] { return finish(run, start), 0; });
  } catch (const RunError& error) {
    if (run.result.time.empty()) store(run, rolling, parts);
    run.result.stopReason = std::string("failed: ") + error.what();
    finish(run, start);
    if (partial) *partial = run.result;
    throw;
  }
  return run.result;
}

}  // namespace squat::simulation
