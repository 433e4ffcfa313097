#include "simulation/RunCase.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "case/CaseFile.h"
#include "case/MeshPresets.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "simulation/RunParts.h"
#include "simulation/SurfaceFields.h"
#include "statics/QuietStart.h"
#include "statics/UnloadedShape.h"

#ifndef SQUAT_VERSION
#define SQUAT_VERSION "unknown"
#endif

namespace squat::simulation {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double frameFrom = -0.06, frameTo = 0.12;  // [m] stretch about the defect of which frames are kept
constexpr int frames = 12;
constexpr long mostStepsAtOnce = 24;  // cancel is asked at least this often
constexpr int samplesPerLedger = 5;   // output samples between entries of the ledger

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
  const RunOptions& options;
  Monitor& monitor;
  results::RunResult result;
  std::vector<results::Scalar> phases;

  template <typename Phase>
  auto timed(const char* name, const Phase& phase) {
    const auto start = Clock::now();
    Progress begun;
    begun.phase = name;
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
  for (const auto& warning : validation.warnings) warn(run, toText(warning));
  if (const std::string note = cases::presetNote(run.description); !note.empty()) warn(run, note);
}

void identify(Run& run, const elasticity::KernelSet& kernels, int threads) {
  auto& r = run.result;
  r.title = run.description.title;
  r.caseToml = cases::writeCase(run.description);
  r.caseHash = cases::caseHash(run.description);
  r.codeVersion = SQUAT_VERSION;
  r.isa = kernels.name;
  r.threads = threads;
  r.created = utcNow();
  r.speed = run.description.motion.speed;
  r.stopReason = "cancelled";
}

// Steps per output sample: the stable step, or the user's where it is shorter.
long stepsPerSample(const cases::CaseDescription& d, const dynamics::StableStep& stable) {
  const double sample = 1 / d.output.rate;
  if (d.output.timeStep > stable.step)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at most " + std::to_string(stable.step * 1e6) + " us: the stable step of this mesh",
                      "Leave it at 0 for the stable step; it is set by " + stable.place}});
  const double wished = d.output.timeStep > 0 ? d.output.timeStep : stable.step;
  if (sample / wished > mostStepsPerSample)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at least " + std::to_string(sample / mostStepsPerSample * 1e6) + " us",
                      "Leave it at 0 for the stable step; it is set by " + stable.place}});
  return std::max(2L, static_cast<long>(std::ceil(sample / wished - 1e-9)));
}

// The rolling phase: the loop, its observers and its checkpoints.
class RollingPhase {
 public:
  RollingPhase(Run& run, dynamics::Rolling& rolling, const SurfaceFields* fields, const RunStart& start,
               double startStrain)
      : run_(run),
        rolling_(rolling),
        fields_(fields),
        start_(start),
        perSample_(start.stepsPerSample),
        recorder_(rolling.stepSize(), static_cast<std::size_t>(start.stepsPerSample)),
        ledger_(rolling, startStrain) {
    const auto& m = run.description.motion;
    const double duration = (m.runUp + m.beyond) / m.speed;
    samples_ = static_cast<long>(std::floor(duration * run.description.output.rate)) + 1;
    total_ = samples_ * perSample_ + static_cast<long>(std::ceil(recorder_.wait() / rolling.stepSize()));
  }

  // True when it ran to its end, false when cancelled.
  bool go() {
    started_ = Clock::now(), lastCheckpoint_ = started_, firstStep_ = rolling_.state().step;
    guard_.goOnFrom(rolling_.state().time);
    DivergenceGuard::checkEverything(rolling_);
    if (firstStep_ == 0) checkpoint();
    const auto observe = [this](const dynamics::StepView& view) { recorder_.observe(view); };
    long atOnce = 1;  // the first step alone: a state from a file is judged before it can fly apart
    while (rolling_.state().step < total_) {
      const long done = rolling_.state().step;
      if (done % (samplesPerLedger * perSample_) == 0) {
        ledger_.before(rolling_);
        rolling_.advance(1, observe);
        ledger_.after(rolling_);
        DivergenceGuard::checkEverything(rolling_);
      } else {
        rolling_.advance(std::min({atOnce, toNextLook(done), total_ - done}), observe);
      }
      atOnce = mostStepsAtOnce;
      guard_.check(rolling_, ledger_);
      // Pictures are taken at the same steps however often the run was stopped.
      if (rolling_.state().step % perSample_ % mostStepsAtOnce == 0) takePictures();
      tell();
      const auto asked = Clock::now();
      while (run_.monitor.paused() && !run_.monitor.cancelled()) wait();
      const auto rested = Clock::now() - asked;  // no part of the run
      started_ += rested, lastCheckpoint_ += rested;
      if (run_.monitor.cancelled()) {
        checkpoint();
        return false;
      }
      if (!run_.options.checkpointPath.empty() && secondsSince(lastCheckpoint_) > run_.options.checkpointSeconds)
        checkpoint();
    }
    if (!rolling_.model().layer.empty()) checkpoint();  // unloading follows, and can be cancelled too
    return true;
  }

  void store() {
    auto& r = run_.result;
    recorder_.store(r, run_.description.output.filterCutoff);
    const std::size_t wanted = std::min<std::size_t>(static_cast<std::size_t>(samples_), r.time.size());
    r.time.resize(wanted), r.position.resize(wanted);
    for (auto& channel : r.signals) channel.values.resize(wanted);
    r.energyTime = ledger_.times();
    r.energy = ledger_.channels();
    const auto shares = ledger_.shares();
    r.equilibrium.push_back({"strain_energy_rail", "J", "at the end", shares.rail});
    r.equilibrium.push_back({"strain_energy_wheelset", "J", "at the end", shares.wheelset});
    r.equilibrium.push_back({"strain_energy_sleepers", "J", "at the end", shares.sleepers});
    r.equilibrium.push_back({"strain_energy_springs", "J", "at the end", shares.springs});
    const long steps = rolling_.state().step - firstStep_;
    const double seconds = secondsSince(started_);
    r.performance.push_back({"steps", "1", "", static_cast<double>(rolling_.state().step)});
    r.performance.push_back({"rolling_seconds", "s", "wall time", seconds});
    r.performance.push_back({"element_updates_per_second", "1/s", "elements times steps over wall time of the rolling",
                             static_cast<double>(steps) * static_cast<double>(rolling_.model().elements()) / seconds});
    r.performance.push_back({"energy_residual", "1", "largest, of strain energy at the start plus all dissipation",
                             ledger_.largestRelativeResidual()});
  }

  // A state that has gone astray never replaces a good checkpoint (RunError). One that cannot be written is no reason
  // to lose the run: that is told, the earlier one stays, and the run goes on.
  void checkpoint() {
    if (run_.options.checkpointPath.empty()) return;
    DivergenceGuard::checkEverything(rolling_);
    results::ArrayTree tree;
    setAttribute(tree.attributes, "case_hash", run_.result.caseHash);
    setAttribute(tree.attributes, "code_version", run_.result.codeVersion);
    setAttribute(tree.attributes, "isa", run_.result.isa);
    saveRolling(rolling_, tree);
    recorder_.save(tree);
    const auto shares = ledger_.shares();
    tree.add("/ledger", ledger_.pack(), "1");
    tree.add("/ledger_shares", std::vector<double>{shares.rail, shares.wheelset, shares.sleepers, shares.springs}, "J");
    saveStart(start_, run_.result, tree);
    savePictures(run_.result, tree);
    try {
      results::writeCheckpoint(run_.options.checkpointPath, std::move(tree));
    } catch (const FileError& error) {
      if (!std::exchange(toldOfCheckpoint_, true))
        warn(run_, std::string("the run goes on without this checkpoint: ") + error.what());
    }
    lastCheckpoint_ = Clock::now();
  }

  // Goes on from a checkpoint. Throws FileError for one that does not fit this run, before anything is taken from it.
  void load(const results::ArrayTree& tree) {
    const auto& file = run_.options.checkpointPath;
    requireFittingState(tree, rolling_, total_, file);
    rolling_.restore(loadRolling(tree));
    recorder_.load(tree, file);
    ledger_.unpack(results::valuesOf<double>(tree, "/ledger", file));
    if (tree.find("/ledger_shares")) {
      const auto& shares = results::valuesOf<double>(tree, "/ledger_shares", file);
      if (shares.size() != 4) throw FileError(file, "/ledger_shares", "has a wrong length");
      ledger_.setShares({shares[0], shares[1], shares[2], shares[3]});
    }
    loadPictures(tree, file, run_.result);
  }

 private:
  void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(50)); }

  double referencePosition() const {
    return rolling_.model().startX + run_.description.motion.speed * rolling_.state().time;
  }

  bool has(const std::string& name) const {
    return std::any_of(run_.result.snapshots.begin(), run_.result.snapshots.end(),
                       [&](const auto& s) { return s.name == name; });
  }

  void picture(const std::string& name) {
    const double travel = rolling_.view().position - rolling_.model().startX;
    run_.result.snapshots.push_back(fields_->snapshot(name, rolling_.displacement(), rolling_.state().time, travel,
                                                      rolling_.state().rotation, rolling_.state().plastic));
    run_.result.patches.push_back(patchSnapshot(name, rolling_));
  }

  // Steps to the next place of a fixed grid, laid anew in every sample.
  long toNextLook(long done) const {
    const long offset = done % perSample_;
    return std::min(perSample_ - offset, mostStepsAtOnce - offset % mostStepsAtOnce);
  }

  void takePictures() {
    if (!fields_) return;
    const double x = referencePosition();
    if (x >= 0 && !has("impact")) picture("impact");
    const int frame = static_cast<int>(std::floor((x - frameFrom) / (frameTo - frameFrom) * frames));
    if (x < frameFrom || frame >= frames) return;
    char name[24];
    std::snprintf(name, sizeof name, "frame %02d", frame);
    if (!has(name)) picture(name);
  }

  void tell() {
    const long done = rolling_.state().step;
    const double seconds = secondsSince(started_);
    if (seconds - lastTold_ < 0.1 && done < total_) return;
    lastTold_ = seconds;
    Progress p;
    p.phase = "rolling";
    p.fraction = static_cast<double>(done) / static_cast<double>(total_);
    p.simulatedTime = rolling_.state().time;
    const double rate = static_cast<double>(done - firstStep_) / std::max(seconds, 1e-3);
    if (seconds > 0.5) p.remainingSeconds = static_cast<double>(total_ - done) / std::max(rate, 1e-3);
    p.elementUpdatesPerSecond = rate * static_cast<double>(rolling_.model().elements());
    p.position = rolling_.view().position;
    p.contactForce = rolling_.view().patch.vertical;
    p.axleBoxAcceleration = recorder_.latestAxleBox();
    p.accelerationPosition = p.simulatedTime > recorder_.wait() ? recorder_.latestPosition() : p.position;
    p.energyResidual = ledger_.relativeResidual();
    run_.monitor.report(p);
  }

  Run& run_;
  dynamics::Rolling& rolling_;
  const SurfaceFields* fields_;
  RunStart start_;
  bool toldOfCheckpoint_ = false;
  long perSample_, samples_ = 0, total_ = 0, firstStep_ = 0;
  Recorder recorder_;
  EnergyLedger ledger_;
  DivergenceGuard guard_;
  Clock::time_point started_, lastCheckpoint_;
  double lastTold_ = -1;
};

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
  std::snprintf(text, sizeof text, "the wheel spins: its rim runs %.1f %% %s than the train; lower the torque",
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
  const auto& d = run.description;
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
  const std::string lacking = addSpectra(run.description, r);
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
  Run run{description, options, monitor, {}, {}};
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

  const model::Model model = run.timed("mesh", [&] { return model::buildModel(description); });
  if (description.rail.plastic && model.layer.empty())
    warn(run,
         "rail.plastic_depth is less than half an element of the head: no element can yield, the rail stays elastic");
  describeProfile(description, run.result);
  Beginning beginning;
  if (checkpoint)
    beginning.steps = loadStart(*checkpoint, options.checkpointPath, description.output.rate, run.result);
  else
    beginning = begin(run, model, kernels, team);
  if (beginning.cancelled) return run.result;

  std::unique_ptr<SurfaceFields> fields;
  if (options.snapshots) {
    fields = std::make_unique<SurfaceFields>(model);
    run.result.surface = fields->mesh();
  }
  dynamics::Rolling rolling(model, kernels, team, beginning.steps.step, beginning.steps.beta);
  const auto& motion = description.motion;
  const auto& displacement = beginning.quiet.equilibrium.displacement;
  if (checkpoint)
    rolling.start(AlignedVector(model.stateSize, 0.0), AlignedVector(model.stateSize, 0.0), 0);
  else
    rolling.start(displacement, beginning.quiet.velocity,
                  motion.angularVelocity > 0 ? motion.angularVelocity : motion.speed / model.surfaces.radius);
  if (fields && !checkpoint)
    run.result.snapshots.push_back(fields->snapshot("equilibrium", displacement, 0, 0, 0, rolling.state().plastic));

  RollingPhase phase(run, rolling, fields.get(), beginning.steps, beginning.quiet.equilibrium.strainEnergy);
  if (checkpoint) phase.load(*checkpoint);
  try {
    bool complete = run.timed("rolling", [&] { return phase.go(); });
    phase.store();
    markSpin(run, model.surfaces.radius);
    if (complete && !model.layer.empty())
      complete = run.timed("unloading", [&] { return unload(run, rolling, team, fields.get()); });
    run.result.complete = complete;
    run.result.stopReason = complete ? "done" : "cancelled";
    run.timed("spectra", [&] { return finish(run, start), 0; });
  } catch (const RunError& error) {
    if (run.result.time.empty()) phase.store();
    run.result.stopReason = std::string("failed: ") + error.what();
    finish(run, start);
    if (partial) *partial = run.result;
    throw;
  }
  return run.result;
}

}  // namespace squat::simulation
