#include "simulation/DivergenceGuard.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/Errors.h"
#include "core/OrderedSum.h"
#include "model/InvertedElement.h"

namespace squat::simulation {

namespace {

// Behind a location.
std::string sideName(std::size_t side) { return side == 0 ? "" : ", right side"; }

// A not-a-number is beyond all numbers.
bool isBeyond(double value, double other) {
  return std::isnan(value) ? !std::isnan(other) : std::abs(value) > std::abs(other);
}

std::string ofSecond(const char* part, const dynamics::Rolling& first) {
  char text[80];
  std::snprintf(text, sizeof text, "%s of the second wheelset at x %.4f m", part,
                first.second()->placeAt(first.state().step));
  return text;
}

struct MovingPart {
  double velocity = 0;  // [m/s]
  std::string location;
};

// The part of the second wheelset that moves fastest on a side; at rest and nowhere where there is none.
MovingPart fastestOfSecond(const dynamics::Rolling& first, std::size_t side) {
  MovingPart fastest;
  if (!first.second()) return fastest;
  const auto [wheel, box, sprung] = first.second()->velocities(side);
  for (const auto& [part, velocity] : {std::pair{"wheel", wheel}, {"axle box", box}, {"sprung mass", sprung}})
    if (isBeyond(velocity, fastest.velocity)) fastest = {velocity, ofSecond(part, first)};
  return fastest;
}

// The unknown of a side that moves fastest, and whether it is where the second wheelset presses on the rail.
MovingPart fastestOfMesh(const dynamics::Rolling& first, std::size_t side) {
  const auto& rolling = *first.sides()[side];
  const auto& velocity = rolling.state().velocity;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    if (!(std::abs(velocity[i]) <= std::abs(velocity[worst]))) worst = i;
  const auto& model = rolling.model();
  MovingPart fastest{velocity[worst], model::locationName(model, worst)};
  const auto& rail = model.blocks[model.rail];
  if (!first.second() || worst < rail.offset || worst >= rail.offset + rail.size()) return fastest;
  const int station = std::min(rail.unknownAt(worst).station, rail.intervals);
  if (std::abs(rail.positions[station] - first.second()->placeAt(first.state().step)) <= model.second->spread)
    fastest.location += ", below the second wheelset";
  return fastest;
}

// [m] Of wheel and rail; 0 where there is no second wheelset.
double approachOfSecond(const dynamics::Rolling& rolling) {
  if (!rolling.model().second) return 0;
  return rolling.model().second->approach(rolling.view().second.force);
}

}  // namespace

DivergenceGuard::DivergenceGuard(const dynamics::Rolling& rolling, const EnergyBalance& balance, long perSample,
                                 long grid)
    : balance_(balance),
      perSample_(perSample),
      grid_(grid),
      firstStep_(rolling.state().step),
      lastContact_(rolling.sides().size(), rolling.state().time) {}

// The first step alone: a state from a file is judged before it can fly apart. Then a fixed grid, laid anew in every
// sample.
long DivergenceGuard::nextStep(long done) const {
  if (done == firstStep_) return done + 1;
  const long offset = done % perSample_;
  return done + std::min(perSample_ - offset, grid_ - offset % grid_);
}

void DivergenceGuard::onStep(const dynamics::Rolling& rolling) {
  if (balance_.entries() != entries_) {
    entries_ = balance_.entries();
    checkEverything(rolling, displacement_);
  }
  for (std::size_t i = 0; i < lastContact_.size(); ++i) check(rolling, i);
}

void DivergenceGuard::checkEverything(const dynamics::Rolling& rolling) {
  AlignedVector displacement;
  checkEverything(rolling, displacement);
}

void DivergenceGuard::checkEverything(const dynamics::Rolling& rolling, AlignedVector& displacement) {
  for (std::size_t i = 0; i < rolling.sides().size(); ++i) checkSide(rolling, i, displacement);
}

void DivergenceGuard::checkSide(const dynamics::Rolling& first, std::size_t side, AlignedVector& displacement) {
  constexpr double absurd = 1e4;  // [m], [m/s] beyond the speed of sound in steel; a not-a-number is not below it
  const auto& rolling = *first.sides()[side];
  const auto& state = rolling.state();
  const auto isAbsurd = [](double value) { return !(std::abs(value) < absurd); };
  const auto second = fastestOfSecond(first, side);
  const auto diverges = [&](const std::string& location) {
    throw RunError("the run diverges: a displacement or velocity is not a number or grows without bound", state.step,
                   state.time, location + sideName(side));
  };
  for (const auto* values : {&state.displaced, &state.velocity}) {
    const auto count = orderedSum(rolling.team(), values->size(), 0L, [&](std::size_t begin, std::size_t end) {
      long found = 0;
      for (std::size_t i = begin; i < end; ++i) found += isAbsurd((*values)[i]);
      return found;
    });
    if (count == 0) continue;
    const auto at = static_cast<std::size_t>(std::find_if(values->begin(), values->end(), isAbsurd) - values->begin());
    diverges(isBeyond(second.velocity, (*values)[at]) ? second.location : model::locationName(rolling.model(), at));
  }
  if (isAbsurd(second.velocity)) diverges(second.location);
  if (!(std::abs(state.rotation) < maximumRotation) || !(std::abs(state.angularVelocity) < maximumAngularVelocity))
    throw RunError("the run diverges: the angular velocity of the wheel grows without bound", state.step, state.time,
                   "wheelset");
  rolling.displacement(displacement);
  if (const auto location = model::invertedElement(rolling.model(), displacement, &rolling.team()); !location.empty())
    throw RunError("an element is turned inside out", state.step, state.time, location + sideName(side));
}

void DivergenceGuard::check(const dynamics::Rolling& first, std::size_t side) {
  const auto& rolling = *first.sides()[side];
  const auto& view = rolling.view();
  const auto& state = rolling.state();
  const auto fail = [&](const std::string& what, const std::string& location) {
    throw RunError(what, state.step, state.time, location + sideName(side));
  };
  const auto diverges = [&] {
    const auto second = fastestOfSecond(first, side), mesh = fastestOfMesh(first, side);
    fail("the run diverges: a velocity is not a number or grows without bound",
         isBeyond(second.velocity, mesh.velocity) ? second.location : mesh.location);
  };
  if (!std::isfinite(view.patch.vertical) || !std::isfinite(view.boxAcceleration.z) ||
      !std::isfinite(view.second.boxAcceleration) || !(std::abs(state.angularVelocity) < maximumAngularVelocity))
    diverges();
  const double approach = approachOfSecond(rolling), deepest = std::max(view.patch.deepest, approach);
  if (deepest > 2e-3)
    fail("runaway penetration of " + std::to_string(deepest * 1e3) + " mm",
         approach > view.patch.deepest ? ofSecond("contact", first) : "contact");
  if (std::abs(view.patch.vertical) > 1e3 * rolling.wheelLoad()) diverges();
  if (view.patch.points > 0) lastContact_[side] = state.time;
  if (state.time - lastContact_[side] > 0.010) fail("the wheel has lost contact for 10 ms", "contact");
  if (std::abs(balance_.relativeResidual()) > 0.005)
    fail("the energy balance does not close: error " + std::to_string(100 * balance_.relativeResidual()) +
             " % of the strain energy at the start plus all dissipation",
         "energy");
}

}  // namespace squat::simulation
