#include "simulation/OpenRun.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <utility>

#include "case/CaseFile.h"
#include "case/MeshPresets.h"
#include "case/Resolve.h"
#include "case/RightSide.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "core/platform/Clock.h"
#include "model/CentrePlane.h"
#include "simulation/Describe.h"
#include "simulation/RollingStateFile.h"
#include "simulation/WarmState.h"
#include "statics/SteadyRollingStart.h"
#include "statics/WholeSystem.h"

namespace squat::simulation {

namespace {

constexpr long maximumStepsAtOnce = 24;  // cancel is asked at least this often
constexpr int samplesPerBalance = 5;     // output samples between entries of the energy balance

std::string utcNow() {
  char text[32];
  const std::tm utc = platform::utcDate(std::time(nullptr));
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

// Steps per output sample: the stable step, or the user's where it is shorter.
long stepsPerSample(const scenario::Scenario& d, const dynamics::StableStep& stable) {
  const double sample = 1 / d.output.rate;
  if (d.output.timeStep > stable.step)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at most " + std::to_string(stable.step * 1e6) + " us: the stable step of this mesh",
                      "Leave it at 0 for the stable step; it is set by " + stable.location}});
  const double requested = d.output.timeStep > 0 ? d.output.timeStep : stable.step;
  if (sample / requested > maximumStepsPerSample)
    throw CaseError({{"output.time_step", std::to_string(d.output.timeStep * 1e6) + " us",
                      "0 or at least " + std::to_string(sample / maximumStepsPerSample * 1e6) + " us",
                      "Leave it at 0 for the stable step; it is set by " + stable.location}});
  return std::max(2L, static_cast<long>(std::ceil(sample / requested - 1e-9)));
}

void reportStep(Monitor& monitor, double step, const std::string& location) {
  Progress progress;
  progress.phase = "stable step";
  progress.fraction = 1;
  progress.step = step;
  progress.limitedBy = location;
  monitor.report(progress);
}

}  // namespace

RollingRun::RollingRun(const RunOptions& options, results::RunResult& result, Monitor& monitor,
                       dynamics::Rolling& rolling, const ModelFields* fields, const RunStart& start, double startStrain,
                       long last, std::function<void(const std::string&)> warn)
    : balance(rolling, startStrain),
      recorder(rolling, static_cast<std::size_t>(start.stepsPerSample)),
      energy(balance, samplesPerBalance * start.stepsPerSample),
      guard(rolling, balance, start.stepsPerSample, maximumStepsAtOnce),
      firstStep(rolling.state().step),
      lastStep(last),
      progress(rolling, lastStep, recorder, balance, clock, monitor),
      checkpoint({options.checkpointPath, options.checkpointSeconds}, start, observers, result, clock,
                 std::move(warn)) {
  observers = {&recorder, &energy, &guard};
  if (fields) observers.push_back(&frames.emplace(*fields, result, start.stepsPerSample, maximumStepsAtOnce));
  if (options.sampled) observers.push_back(&stream.emplace(recorder, options.sampled));
  observers.insert(observers.end(), {&progress, &checkpoint});
}

OpenRun::OpenRun(const cases::CaseDescription& d, const RunOptions& o, Monitor& m)
    : description(d), sides(cases::resolveSides(d)), scenario(sides.left), options(o), monitor(m) {
  refuseOrWarn();
  try {
    kernels = elasticity::kernelsFor(options.isa);
  } catch (const std::invalid_argument& error) {
    throw CaseError({{"--isa", options.isa, "one that this processor has", error.what()}});
  }
  team = std::make_unique<ThreadTeam>(threadCount(options.threads));
  identify();
}

void OpenRun::warn(const std::string& text) {
  result.warnings.push_back(text);
  monitor.message("warning: " + text);
}

void OpenRun::reportPhase(const char* name) {
  Progress progress;
  progress.phase = name;
  std::replace(progress.phase.begin(), progress.phase.end(), '_', ' ');
  monitor.report(progress);
}

void OpenRun::refuseOrWarn() {
  const auto validation = cases::validate(description);
  if (!validation.problems.empty()) throw CaseError(validation.problems);
  for (const auto& warning : validation.warnings) warn(toWarning(warning));
  // What the mesh stands for, no fault of the case: reported, and not kept among the warnings of the result.
  if (const std::string note = cases::presetNote(description); !note.empty()) monitor.message("note: " + note);
}

void OpenRun::identify() {
  result.title = description.title;
  results::setCase(result, description);
  result.codeVersion = programVersion();
  result.commit = programCommit();
  result.isa = kernels.name;
  result.threads = team->size();
  result.created = utcNow();
  result.speed = scenario.motion.speed;
  result.stopReason = "cancelled";
}

long OpenRun::samples() const {
  const auto& motion = scenario.motion;
  return static_cast<long>(std::floor((motion.runUp + motion.beyond) / motion.speed * scenario.output.rate)) + 1;
}

long OpenRun::lastStep() const {
  const SignalRecorder recorder(*rolling, static_cast<std::size_t>(steps.stepsPerSample));
  return samples() * steps.stepsPerSample + static_cast<long>(std::ceil(recorder.wait() / rolling->stepSize()));
}

bool OpenRun::start(const StoredState* stored) {
  const auto* made = options.warm ? options.warm->model.get() : nullptr;
  // Natural modes need nothing but the scenario: where there is a second thread, it finds them beside the mesh.
  std::future<Modes> modes;
  if (!stored && options.wheelsetModes)
    modes = std::async(team->size() > 1 ? std::launch::async : std::launch::deferred,
                       [this] { return naturalModes(scenario); });
  model = timed("mesh", [&] { return made ? withDefect(*made, scenario) : model::buildModel(scenario); });
  if (sides.right) rightModel = model::buildModel(*sides.right);
  if (scenario.rail.plastic && model.layer.empty())
    warn("rail.plastic_depth is less than half an element of the head: no element can yield, the rail stays elastic");
  describeProfile(scenario, result);
  if (!stored) return begin(std::move(modes));
  restore(*stored);
  return true;
}

namespace {

// Half of a whole model with a mirror at the track centre. Its highest frequency is that of the whole, which belongs to
// the smallest elements, far from the centre.
model::Model mirrored(const model::Model& half) {
  model::Model alone = half;
  model::fixUnknowns(alone, model::Centre::symmetric);
  return alone;
}

}  // namespace

// Of both sides the shorter one, where they are not alike.
dynamics::StableStep OpenRun::findStableStep() {
  if (!rightModel) return dynamics::stableStep(model, kernels, *team, monitor);
  auto stable = dynamics::stableStep(mirrored(model), kernels, *team, monitor);
  const bool haveMovedNodes = model.movedElements.size() > 0 || rightModel->movedElements.size() > 0;
  if ((!haveMovedNodes && cases::startsAlike(description)) || monitor.cancelled()) return stable;
  auto right = dynamics::stableStep(mirrored(*rightModel), kernels, *team, monitor);
  return right.step < stable.step ? right : stable;
}

// Sides that differ in what lies ahead alone start as mirror images: for those one half is enough.
std::vector<statics::SteadyRollingStart> OpenRun::findStart() {
  if (rightModel && !cases::startsAlike(description)) {
    statics::WholeSystem system(model, *rightModel, kernels, *team, 0);
    return statics::prepareSteadyRolling(system, monitor);
  }
  if (!rightModel) return {statics::prepareSteadyRollingStart(model, kernels, *team, monitor)};
  const auto start = statics::prepareSteadyRollingStart(mirrored(model), kernels, *team, monitor);
  return {start, start};
}

// Friction, which would hold the wheelset, is not there yet.
void OpenRun::warnOfLateralShift(const statics::Equilibrium& left, const statics::Equilibrium& right) {
  constexpr double usual = 0.1e-3;  // [m]
  const auto outwards = [&](const statics::Equilibrium& e) {
    return ringLateralMean(model, model.bearing, e.displacement.data());
  };
  const double shift = 0.5 * (outwards(left) - outwards(right));
  if (std::abs(shift) < usual) return;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "at rest, where no friction holds it, the wheelset stands %.2f mm to the %s: the forces of the wheels on "
      "the rails are inclined; see motion.lateral_offset of both sides and suspension.lateral_stiffness",
      1e3 * std::abs(shift), shift > 0 ? "left" : "right");
  warn(text);
}

void OpenRun::makeRolling() {
  rolling.emplace(model, kernels, *team, steps.step, steps.beta);
  if (rightModel) {
    rightRolling.emplace(*rightModel, kernels, *team, steps.step, steps.beta);
    rolling->take(*rightRolling);
  }
  if (options.timed) rolling->setTimings(&timings.emplace(team->size()));
}

// Everything ahead of the rolling. A stored state holds what comes of it.
bool OpenRun::begin(std::future<Modes> modes) {
  if (monitor.cancelled()) return false;
  if (modes.valid()) result.modes = timed("modes", [&] { return modes.get(); });
  if (monitor.cancelled()) return false;
  const auto stable = timed("stable_step", [&] { return findStableStep(); });
  if (monitor.cancelled()) return false;
  const long perSample = stepsPerSample(scenario, stable);
  steps = {perSample, 1 / scenario.output.rate / static_cast<double>(perSample), stable.beta};
  describeMesh(model, stable, steps.step, result);
  reportStep(monitor, steps.step, stable.location);
  const auto starts = timed("equilibrium", [&] { return findStart(); });
  const auto& equilibrium = starts.front().equilibrium;
  if (equilibrium.cancelled) return false;
  describeEquilibrium(model, equilibrium, result);
  if (rightModel) describeRightEquilibrium(*rightModel, starts.back().equilibrium, result);
  if (rightModel) warnOfLateralShift(equilibrium, starts.back().equilibrium);
  for (const auto& start : starts) startStrain_ += start.equilibrium.strainEnergy;

  makeRolling();
  const auto& motion = scenario.motion;
  const double right = rightModel ? rightModel->surfaces.radius : model.surfaces.radius;
  const double radius = 0.5 * (model.surfaces.radius + right);  // wheels of unlike rolling radii turn as one
  const double rate = motion.angularVelocity > 0 ? motion.angularVelocity : motion.speed / radius;
  for (std::size_t i = 0; i < starts.size(); ++i)
    rolling->sides()[i]->start(starts[i].equilibrium.displacement, starts[i].velocity, rate);
  rolling->startSecond();
  if (!options.snapshots) return true;
  fields = std::make_unique<ModelFields>(model, rightModel ? &*rightModel : nullptr);
  result.surface = fields->mesh();
  std::vector<ModelFields::State> states;
  for (std::size_t i = 0; i < starts.size(); ++i)
    states.push_back({starts[i].equilibrium.displacement, rolling->sides()[i]->state().plastic});
  result.snapshots.push_back(fields->snapshot("equilibrium", states, 0, 0, 0));
  return true;
}

// Nothing is taken from a stored state before all of it is known to fit.
void OpenRun::restore(const StoredState& stored) {
  steps = loadStart(stored, scenario.output.rate, result);
  if (options.wheelsetModes && result.modes.empty())
    result.modes = timed("modes", [&] { return naturalModes(scenario); });
  if (options.snapshots) {
    fields = std::make_unique<ModelFields>(model, rightModel ? &*rightModel : nullptr);
    result.surface = fields->mesh();
  }
  makeRolling();
  for (auto* side : rolling->sides())
    side->start(AlignedVector(model.stateSize, 0.0), AlignedVector(model.stateSize, 0.0), 0);
  requireFittingState(stored, *rolling, lastStep());
  restoreRolling(stored.tree, *rolling);
  if (options.snapshots) loadPictures(stored.tree, stored.file, result);
}

void OpenRun::observe(const StoredState* stored, long rolledTo) {
  parts.emplace(options, result, monitor, *rolling, fields.get(), steps, startStrain_,
                rolledTo > 0 ? rolledTo : lastStep(), [this](const std::string& text) { warn(text); });
  if (!stored) return;
  for (auto* observer : parts->observers) observer->load(stored->tree, stored->file);
}

}  // namespace squat::simulation
