#include "statics/SteadyRollingStart.h"

#include <algorithm>

#include "statics/VehicleMotion.h"

namespace squat::statics {

namespace {

// Rolled over single elements, a patch of few points comes and goes: the approach of wheel and rail ripples by a micron
// or two within an element. Its slope is part of the equilibrium's rate, and as a velocity of the whole vehicle it
// would shake the wheel for the length of the run-up. Under a constant load the approach is constant: the wheel rises
// and falls with the deflected rail, averaged over more than an element, and with its tread where that is not round.
constexpr double window = 0.025;  // [m] to either side of the wheel: longer than the patch and the elements of any mesh

double verticalAt(const model::Model& model, const AlignedVector& u, double x) {
  const auto& rail = model.blocks[model.rail];
  const auto it = std::upper_bound(rail.positions.begin(), rail.positions.end(), x);
  const int s = std::clamp(static_cast<int>(it - rail.positions.begin()) - 1, 0, rail.intervals - 1);
  const double share = (x - rail.positions[s]) / (rail.positions[s + 1] - rail.positions[s]);
  return (1 - share) * verticalOfRailSection(model, u, s) + share * verticalOfRailSection(model, u, s + 1);
}

// Mean displacement over a window that moves with the wheel: its change per metre [1], of displacements and their rate.
double railRate(const model::Model& model, const AlignedVector& u, const AlignedVector& rate, double x) {
  constexpr int points = 40;
  double sum = 0;
  for (int i = 0; i < points; ++i) sum += verticalAt(model, rate, x + window * ((2 * i + 1.0) / points - 1)) / points;
  return sum + (verticalAt(model, u, x + window) - verticalAt(model, u, x - window)) / (2 * window);
}

// Rise of a wheel that is not round, per metre rolled [1].
double treadRate(const model::Model& model) {
  const auto& d = model.scenario;
  if (d.tread.isRound()) return 0;
  constexpr double step = 0.005;  // [m] about the half length of the patch, which rolls over shorter waves
  const auto path = scenario::rigidWheelPath(scenario::DefectSurface(), d.tread, model.surfaces.radius,
                                             model.startX - step, model.startX + 1.01 * step, 2 * step, 0, 0);
  return (path.back().height - path.front().height) / (2 * step);
}

// What the vehicle's vertical velocity per metre rolled lacks to follow the rail [1].
double missingRate(const model::Model& model, const SteadyRollingStart& start) {
  model::TurnedStations turned;
  model::turnStations(model.blocks[model.body], 0, turned);
  const double wheelRate = model::ringMean(model, model.centre, turned, start.velocity.data()).z;
  const double rate =
      railRate(model, start.equilibrium.displacement, start.velocity, start.equilibrium.wheelX) + treadRate(model);
  return rate - wheelRate;
}

}  // namespace

std::vector<SteadyRollingStart> prepareSteadyRolling(StaticSystem& system, Monitor& monitor) {
  const auto& halves = system.halves();
  const auto found = findEquilibria(system, halves.front().model.startX, {}, monitor);
  std::vector<SteadyRollingStart> starts;
  for (std::size_t i = 0; i < halves.size(); ++i)
    starts.push_back({found[i], AlignedVector(halves[i].model.stateSize, 0.0)});
  if (found.front().cancelled) return starts;
  const auto rate = equilibriumRate(system, found, monitor);
  double turn = 0, mean = 0;
  std::vector<double> missing;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const auto& [model, op, offset] = halves[i];
    auto& start = starts[i];
    start.equilibrium.cancelled = monitor.cancelled();
    start.velocity.assign(rate.data() + offset, rate.data() + offset + model.stateSize);
    missing.push_back(missingRate(model, start));
    mean += missing.back() / static_cast<double>(halves.size());
  }
  if (monitor.cancelled()) return starts;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const auto& model = halves[i].model;
    auto& velocity = starts[i].velocity;
    addVerticalMotion(model, 0, mean, velocity.data());
    if (halves.size() > 1) addRoll(model, 0, missing[i] - mean, velocity.data());
    for (double& value : velocity) value *= model.scenario.motion.speed;
    turn += model::meanRotation(model, velocity.data()) / static_cast<double>(halves.size());
  }
  for (std::size_t i = 0; i < halves.size(); ++i)
    model::removeMeanRotation(halves[i].model, turn, starts[i].velocity.data());
  return starts;
}

SteadyRollingStart prepareSteadyRollingStart(const model::Model& model, const elasticity::KernelSet& kernels,
                                             ThreadTeam& team, Monitor& monitor) {
  HalfSystem system(model, kernels, team, 0);
  return prepareSteadyRolling(system, monitor).front();
}

}  // namespace squat::statics
