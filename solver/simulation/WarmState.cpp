#include "simulation/WarmState.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "case/BeforeDefect.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "case/RightSide.h"
#include "contact/ContactSurfaces.h"
#include "core/Errors.h"
#include "simulation/OpenRun.h"

namespace squat::simulation {

namespace {

// Gap that a point must have to count as not felt [m]: wheel and rail bounce by some micrometres before the defect.
constexpr double untouched = 0.1e-3;
// A state is looked for at least this often [m].
constexpr double stride = 1e-3;

std::string movedKey(const cases::CaseDescription& description) {
  return description.defect.moveNodes ? "defect.move_nodes" : "right.defect.move_nodes";
}

std::string nameOf(const WarmState& warm) { return warm.file.empty() ? "the warm state" : warm.file; }

std::string withUnit(const cases::CaseDescription& description, const cases::Parameter& parameter) {
  const auto text = cases::valueText(description, parameter);
  return parameter.unit.empty() || parameter.unit == "-" ? text : text + " " + parameter.unit;
}

// What is wrong with one side of the zone; `own` of the case, `set` whether its key states it.
void checkZone(const WarmState& warm, const char* key, double own, bool set, double served,
               std::vector<CaseProblem>& problems) {
  if (own == served || (own < served && !set)) return;
  const auto& parameter = *cases::findParameter(key);
  const auto text = [&](double value) {
    auto with = warm.description;
    std::get<double& (*)(cases::CaseDescription&)>(parameter.access)(with) = value;
    return withUnit(with, parameter);
  };
  const bool tooLong = own > served;
  problems.push_back({key, text(own), (tooLong ? "at most " : "") + text(served) + ", as in " + nameOf(warm),
                      tooLong ? "The defect is longer: make the warm state with this value of the key"
                              : "Leave the key out, or make the warm state with this value"});
}

// Contact is looked for, and a rail may yield, this far from below the axis [m].
double reachOf(const scenario::Scenario& scenario) {
  return contact::reachAlong(scenario, contact::seatOf(scenario).radius);
}

void checkDefect(const WarmState& warm, const cases::CaseDescription& description, std::vector<CaseProblem>& problems) {
  if (cases::hasMovedNodes(description))
    problems.push_back({movedKey(description), "true", "false with a warm state",
                        "Moved nodes change the stiffness of the rail, which waves feel before the wheel arrives: "
                        "run the whole case"});
  const auto own = cases::defectZone(description), served = cases::defectZone(warm.description);
  const auto& mesh = description.mesh;
  checkZone(warm, "mesh.zone_before", own.before, mesh.zoneBefore > 0, served.before, problems);
  checkZone(warm, "mesh.zone_behind", own.behind, mesh.zoneBehind > 0, served.behind, problems);
  if (!description.rail.plastic || !problems.empty()) return;
  const double here = reachOf(cases::resolve(description)), there = reachOf(cases::resolve(warm.description));
  if (here == there) return;
  const auto millimetres = [](double metres) { return std::to_string(std::lround(1e3 * metres)) + " mm"; };
  problems.push_back({"rail.plastic", "true", "false for this defect with " + nameOf(warm),
                      "A defect as steep as this one lets the rail yield up to " + millimetres(here) +
                          " from the wheel, that of the warm state up to " + millimetres(there) +
                          ": make a warm state with this defect, or run the whole case"});
}

}  // namespace

void requireFit(const WarmState& warm, const cases::CaseDescription& description) {
  std::vector<CaseProblem> problems;
  for (const auto* parameter : cases::differencesBeforeDefect(description, warm.description)) {
    const auto problemOf = [&](const cases::CaseDescription& own, const cases::CaseDescription& served) {
      return CaseProblem{parameter->key, withUnit(own, *parameter),
                         withUnit(served, *parameter) + ", as in " + nameOf(warm),
                         "Only the defect may differ from what the warm state was made for"};
    };
    const bool onLeft = cases::valueText(description, *parameter) != cases::valueText(warm.description, *parameter);
    problems.push_back(onLeft
                           ? problemOf(description, warm.description)
                           : cases::onRight(problemOf(cases::rightOf(description), cases::rightOf(warm.description))));
  }
  if (problems.empty()) checkDefect(warm, description, problems);
  if (!problems.empty()) throw CaseError(problems);
}

bool fits(const WarmState& warm, const cases::CaseDescription& description) {
  try {
    requireFit(warm, description);
    return true;
  } catch (const CaseError&) {
    return false;
  }
}

cases::CaseDescription onMeshOf(const WarmState& warm, cases::CaseDescription description) {
  const auto zone = cases::defectZone(warm.description);
  if (cases::defectZone(description) == zone) return description;
  description.mesh.zoneBefore = zone.before, description.mesh.zoneBehind = zone.behind;
  return description;
}

void requireAhead(const WarmState& warm, const dynamics::Rolling& rolling) {
  const auto isAhead = [](const dynamics::Rolling* side) {
    const auto& surface = side->model().scenario.defectSurface;
    return surface.first() == surface.last() || side->frontOfContact(0.5 * untouched) < surface.first();
  };
  if (std::all_of(rolling.sides().begin(), rolling.sides().end(), isAhead)) return;
  throw CaseError({{"--warm", nameOf(warm), "a state before the wheel feels the defect",
                    "The profile rises so high that the wheel touches it earlier: make the warm state with this "
                    "defect, or with a longer mesh.zone_before"}});
}

StoredState storedIn(const WarmState& warm) {
  return {warm.state, nameOf(warm), "make the warm state anew with squat warm"};
}

std::size_t byteCount(const WarmState& warm) { return sizeof warm + results::byteCount(warm.state); }

namespace {

void refuseMovedNodes(const cases::CaseDescription& description) {
  if (cases::hasMovedNodes(description))
    throw CaseError({{movedKey(description), "true", "false for a warm state",
                      "Moved nodes change the stiffness of the rail, which waves feel before the wheel arrives"}});
}

// Steps between two looks at the contact, and the gap [m] that tells at one that the next will not be too late: between
// them the gap of a point that the wheel nears closes by the way times the slope of the tread there.
struct Looks {
  explicit Looks(const OpenRun& run) {
    const double perStep = run.scenario.motion.speed * run.rolling->stepSize();
    steps = std::clamp(static_cast<long>(stride / perStep), 1L, run.steps.stepsPerSample);
    const auto& s = run.model.surfaces;
    margin = untouched + static_cast<double>(steps) * perStep * 0.020 / s.radius;
    // The deviation of a tread that is not round turns towards it as well.
    if (!s.treadCurve.empty()) margin += static_cast<double>(steps) * perStep * s.treadSteepest;
  }
  long steps = 1;
  double margin = 0;
};

// [m] x of the foremost contact point of any wheel with a gap below `margin`.
double frontOf(const dynamics::Rolling& rolling, double margin) {
  double front = -std::numeric_limits<double>::infinity();
  for (const auto* side : rolling.sides()) front = std::max(front, side->frontOfContact(margin));
  return front;
}

void requireRoom(const OpenRun& run, double zone) {
  if (frontOf(*run.rolling, Looks(run).margin) < zone) return;
  throw CaseError(
      {{"motion.run_up", withUnit(run.description, *cases::findParameter("motion.run_up")),
        "such that the wheel starts some 20 mm before the defect and mesh.zone_before", "Lengthen the run-up"}});
}

// Rolls on until the wheel is about to feel the zone, which begins at `zone` [m]. False where it was cancelled.
bool rollUpTo(OpenRun& run, double zone) {
  auto& rolling = *run.rolling;
  const Looks looks(run);
  DivergenceGuard::checkEverything(rolling);
  while (frontOf(rolling, looks.margin) < zone)
    if (roll(rolling, rolling.state().step + looks.steps, run.parts->observers, run.monitor, run.parts->clock) ==
        LoopEnd::cancelled)
      return false;
  if (frontOf(rolling, 0.5 * untouched) >= zone)
    throw RunError("the wheel touched the defect before a state could be taken", rolling.state().step,
                   rolling.state().time, "contact");
  return true;
}

void keepState(const OpenRun& run, WarmState& warm) {
  warm.position = run.rolling->view().position;
  warm.state = stateOf(*run.rolling, run.steps, run.parts->observers, run.result);
}

}  // namespace

std::optional<WarmState> makeWarmState(const cases::CaseDescription& description, const RunOptions& options,
                                       Monitor& monitor) {
  refuseMovedNodes(description);
  auto plain = options;
  plain.checkpointPath.clear(), plain.resume = false, plain.warm.reset();
  WarmState warm;
  warm.description = description;
  const auto zone = cases::defectZone(description);
  warm.description.mesh.zoneBefore = zone.before, warm.description.mesh.zoneBehind = zone.behind;
  OpenRun run(warm.description, plain, monitor);
  if (!run.start(nullptr)) return std::nullopt;
  const auto way = run.scenario.motion.runUp - zone.before - 0.014;  // about
  run.observe(nullptr, std::max(1L, std::lround(way / (run.scenario.motion.speed * run.rolling->stepSize()))));
  requireRoom(run, -zone.before);
  if (!run.timed("rolling", [&] { return rollUpTo(run, -zone.before); })) return std::nullopt;
  keepState(run, warm);
  warm.model = std::make_shared<const model::Model>(run.model);
  return warm;
}

std::optional<WarmState> rollOn(const std::shared_ptr<const WarmState>& warm, const cases::CaseDescription& description,
                                double before, const RunOptions& options, Monitor& monitor) {
  requireFit(*warm, description);
  auto plain = options;
  plain.checkpointPath.clear(), plain.resume = false, plain.warm = warm;
  WarmState nearer;
  nearer.description = onMeshOf(*warm, description);
  nearer.model = warm->model;
  OpenRun run(nearer.description, plain, monitor);
  const auto stored = storedIn(*warm);
  if (!run.start(&stored)) return std::nullopt;
  requireAhead(*warm, *run.rolling);
  run.observe(&stored);
  if (!run.timed("rolling", [&] { return rollUpTo(run, -before); })) return std::nullopt;
  keepState(run, nearer);
  return nearer;
}

}  // namespace squat::simulation
