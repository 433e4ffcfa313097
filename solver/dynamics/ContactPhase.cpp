#include "dynamics/ContactPhase.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/ContactPenalty.h"

namespace squat::dynamics {

ContactPhase::ContactPhase(const model::Model& model, double step, double beta)
    : model_(model),
      step_(step),
      pair_{model.surfaces,
            model.blocks[model.rail],
            model.blocks[model.rim],
            {model::normalPenalty(model.scenario), model::tangentialPenalty(model.scenario),
             model.scenario.contact.friction, contact::wearLawOf(model.scenario)}},
      inertia_(model, stiffestPenalty(model.scenario), step, beta) {}

contact::ForceLines ContactPhase::linesOf(int block, double* forces) const {
  return {forces + model_.loaded[block].offset, model_.loaded[block].lineOfNode.data()};
}

contact::ContactMotion ContactPhase::motionOf(const contact::WheelRolling& wheel, const RollingState& state) const {
  return {wheel, state.displaced.data(), state.velocity.data(), step_};
}

// Points that may touch soon are looked for some microseconds ahead. Surfaces approach each other with the rolling, by
// speed times reach over radius (and the slope of a tread that is not round), and with a metre per second or two as
// elements spring and bodies bounce.
void ContactPhase::listNearPoints(const contact::WheelPlacement& wheel, const RollingState& state) {
  if (state.step < nearUntil_) return;
  constexpr double ahead = 5e-6, bounce = 8;  // [s], [m/s]
  const auto& s = model_.surfaces;
  const auto steps = std::max(1L, std::lround(ahead / step_));
  const double speed = std::abs(model_.scenario.motion.speed);
  const double approach = bounce + speed * s.reach / s.radius + speed * s.treadSteepest;
  near_ = pointsWithin(approach * static_cast<double>(steps) * step_, pair_, wheel, state.displaced.data());
  nearUntil_ = state.step + steps;
}

contact::PatchState ContactPhase::evaluate(const contact::WheelRolling& wheel, RollingState& state, double* forces) {
  listNearPoints(wheel.placement, state);
  return rollContact(pair_, motionOf(wheel, state), state.friction,
                     {linesOf(model_.rail, forces), linesOf(model_.rim, forces)},
                     {&near_, nullptr, &inertia_.closed()});
}

std::vector<contact::PatchPoint> ContactPhase::points(const contact::WheelRolling& wheel,
                                                      const RollingState& state) const {
  AlignedVector forces(model_.forceSize, 0.0);
  auto history = state.friction;
  std::vector<contact::PatchPoint> points;
  rollContact(pair_, motionOf(wheel, state), history,
              {linesOf(model_.rail, forces.data()), linesOf(model_.rim, forces.data())}, {nullptr, &points, nullptr});
  return points;
}

double ContactPhase::front(double margin, const contact::WheelRolling& wheel, const RollingState& state) const {
  const auto& s = model_.surfaces;
  double front = -std::numeric_limits<double>::infinity();
  for (const auto& [interval, column, point] : pointsWithin(margin, pair_, wheel.placement, state.displaced.data()))
    front = std::max(front, s.pointX[s.pointIndex(interval, column, point)]);
  return front;
}

}  // namespace squat::dynamics
