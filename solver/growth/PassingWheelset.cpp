#include "growth/PassingWheelset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/Errors.h"
#include "signals/Butterworth.h"
#include "signals/DecimatingFilter.h"

namespace squat::growth {

namespace {

constexpr long stepsAtOnce = 24;    // cancel is asked at least this often
constexpr double clearance = 2e-3;  // [m] between what the released wheel reaches and the zone
enum Channel { position, acceleration, channels };

simulation::RunOptions optionsFor(int threads, const std::string& isa) {
  simulation::RunOptions options;
  options.threads = threads, options.isa = isa;
  options.wheelsetModes = options.snapshots = false;
  return options;
}

// Of the rail and the sleepers, which are meshed in the same way in the models of all wheelsets.
void addTrack(const model::Model& from, const AlignedVector& displacement, const model::Model& to, AlignedVector& sum) {
  if (displacement.empty()) return;
  const auto addBlock = [&](const elasticity::SweptBlock& own, const elasticity::SweptBlock& other) {
    if (own.nodes != other.nodes || own.stationCount != other.stationCount || own.positions != other.positions)
      throw RunError("the tracks of two wheelsets are meshed in different ways", 0, 0, "growth");
    for (int n = 0; n < own.nodes; ++n)
      for (int c = 0; c < 3; ++c)
        for (int s = 0; s < own.stationCount; ++s) sum[own.index(n, c, s)] += displacement[other.index(n, c, s)];
  };
  addBlock(to.blocks[to.rail], from.blocks[from.rail]);
  for (int i = 0; i < to.sleepers; ++i) addBlock(to.blocks[to.firstSleeper + i], from.blocks[from.firstSleeper + i]);
}

}  // namespace

PassingWheelset::PassingWheelset(cases::CaseDescription description, int threads, const std::string& isa,
                                 Monitor& monitor)
    : description_(std::move(description)), options_(optionsFor(threads, isa)), run_(description_, options_, monitor) {}

bool PassingWheelset::release() {
  if (!run_.start(nullptr)) return false;
  auto& rolling = *run_.rolling;
  const auto& rail = description_.rail;
  double zone = rail.plasticFrom;
  if (!run_.model.layer.empty()) zone = std::min(zone, run_.model.layer.extent.front()[0]);
  const double perStep = description_.motion.speed * rolling.stepSize();
  const double end = zone - run_.model.surfaces.reach - clearance - static_cast<double>(stepsAtOnce) * perStep;
  if (rolling.view().position > end)
    throw CaseError({{"motion.run_up", std::to_string(description_.motion.runUp) + " m",
                      "at least " + std::to_string(description_.motion.runUp + rolling.view().position - end) + " m",
                      "The wheel would start on the stretch of rail that changes"}});
  while (rolling.view().position < end) {
    if (run_.monitor.cancelled()) return false;
    rolling.advance(stepsAtOnce, [](const dynamics::StepView&) {});
  }
  released_ = rolling.state();
  bare_ = bareSurface(run_.model.surfaces);
  return true;
}

dynamics::RollingState PassingWheelset::startOn(const ChangedRail& rail) const {
  auto state = released_;
  const auto& model = run_.model;
  addTrack(rail.model, rail.displacement, model, state.displaced);
  if (!rail.layer.values.empty()) state.plastic = rail.layer;
  state.friction.worn.assign(model.surfaces.points(), 0.0);
  return state;
}

std::optional<Passage> PassingWheelset::roll(const SurfaceGrid& grid, const ChangedRail& rail) {
  auto& rolling = *run_.rolling;
  Field change(rail.shape);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= rail.risen[i];
  layChange(grid, change, steepestAlong(grid, rail.shape), bare_, run_.model.surfaces);
  rolling.restore(startOn(rail));

  Passage passage;
  passage.smallestForce = std::numeric_limits<double>::infinity();
  const double frictionBefore = rolling.state().sums.friction;
  signals::DecimatingFilter filter(rolling.stepSize(), static_cast<std::size_t>(run_.steps.stepsPerSample), channels);
  const auto observe = [&](const dynamics::StepView& view) {
    const double sample[channels] = {view.position, view.boxAcceleration.z};
    filter.push(sample);
    if (view.position < grid.x.front()) return;
    passage.smallestForce = std::min(passage.smallestForce, view.patch.vertical);
    passage.largestForce = std::max(passage.largestForce, view.patch.vertical);
  };
  const double expected = (grid.x.back() - rolling.view().position) / (speed() * rolling.stepSize());
  const long first = rolling.state().step;
  while (rolling.view().position < grid.x.back()) {
    if (run_.monitor.cancelled()) return {};
    rolling.advance(stepsAtOnce, observe);
    if (!std::isfinite(rolling.view().position) || rolling.state().step - first > 2 * expected)
      throw RunError("a wheelset does not pass the rail that has grown", rolling.state().step, rolling.state().time,
                     "growth");
  }
  const auto& state = rolling.state();
  passage.layer = state.plastic, passage.worn = state.friction.worn;
  passage.frictionWork = state.sums.friction - frictionBefore;
  const auto series = filter.finish();
  passage.position = series[position].values;
  passage.acceleration = signals::lowPass(series[acceleration], description_.output.filterCutoff).values;
  return passage;
}

}  // namespace squat::growth
