#include "simulation/DivergenceGuard.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "core/OrderedSum.h"
#include "model/InvertedElement.h"

namespace squat::simulation {

namespace {

// Behind a location.
std::string sideName(std::size_t side) { return side == 0 ? "" : ", right side"; }

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
  for (std::size_t i = 0; i < lastContact_.size(); ++i) check(*rolling.sides()[i], sideName(i), lastContact_[i]);
}

void DivergenceGuard::checkEverything(const dynamics::Rolling& rolling) {
  AlignedVector displacement;
  checkEverything(rolling, displacement);
}

void DivergenceGuard::checkEverything(const dynamics::Rolling& rolling, AlignedVector& displacement) {
  for (std::size_t i = 0; i < rolling.sides().size(); ++i) checkSide(*rolling.sides()[i], sideName(i), displacement);
}

void DivergenceGuard::checkSide(const dynamics::Rolling& rolling, const std::string& where,
                                AlignedVector& displacement) {
  constexpr double absurd = 1e4;  // [m], [m/s] beyond the speed of sound in steel; a not-a-number is not below it
  const auto& state = rolling.state();
  const auto isAbsurd = [](double value) { return !(std::abs(value) < absurd); };
  for (const auto* values : {&state.displaced, &state.velocity}) {
    const auto count = orderedSum(rolling.team(), values->size(), 0L, [&](std::size_t begin, std::size_t end) {
      long found = 0;
      for (std::size_t i = begin; i < end; ++i) found += isAbsurd((*values)[i]);
      return found;
    });
    if (count == 0) continue;
    const auto at = std::find_if(values->begin(), values->end(), isAbsurd) - values->begin();
    throw RunError("the run diverges: a displacement or velocity is not a number or grows without bound", state.step,
                   state.time, model::locationName(rolling.model(), static_cast<std::size_t>(at)) + where);
  }
  if (!(std::abs(state.rotation) < maximumRotation) || !(std::abs(state.angularVelocity) < maximumAngularVelocity))
    throw RunError("the run diverges: the angular velocity of the wheel grows without bound", state.step, state.time,
                   "wheelset");
  rolling.displacement(displacement);
  if (const auto location = model::invertedElement(rolling.model(), displacement, &rolling.team()); !location.empty())
    throw RunError("an element is turned inside out", state.step, state.time, location + where);
}

void DivergenceGuard::check(const dynamics::Rolling& rolling, const std::string& where, double& lastContact) {
  const auto& view = rolling.view();
  const auto& state = rolling.state();
  const auto fail = [&](const std::string& what, const std::string& location) {
    throw RunError(what, state.step, state.time, location + where);
  };
  const auto diverges = [&] {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
      if (!(std::abs(state.velocity[i]) <= std::abs(state.velocity[worst]))) worst = i;
    fail("the run diverges: a velocity is not a number or grows without bound",
         model::locationName(rolling.model(), worst));
  };
  if (!std::isfinite(view.patch.vertical) || !std::isfinite(view.boxAcceleration.z) ||
      !(std::abs(state.angularVelocity) < maximumAngularVelocity))
    diverges();
  if (view.patch.deepest > 2e-3)
    fail("runaway penetration of " + std::to_string(view.patch.deepest * 1e3) + " mm", "contact");
  if (std::abs(view.patch.vertical) > 1e3 * rolling.wheelLoad()) diverges();
  if (view.patch.points > 0) lastContact = state.time;
  if (state.time - lastContact > 0.010) fail("the wheel has lost contact for 10 ms", "contact");
  if (std::abs(balance_.relativeResidual()) > 0.005)
    fail("the energy balance does not close: error " + std::to_string(100 * balance_.relativeResidual()) +
             " % of the strain energy at the start plus all dissipation",
         "energy");
}

}  // namespace squat::simulation
