#include "dynamics/RollingHalves.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "model/BuildForceElements.h"

namespace squat::dynamics {

Rolling::~Rolling() = default;

void Rolling::take(Rolling& right) {
  if (!haveLikeUnknowns(model_, right.model_))
    throw std::invalid_argument("both halves of a wheelset need meshes with the same unknowns");
  if (step_ != right.step_ || beta_ != right.beta_ || &team_ != &right.team_)
    throw std::invalid_argument("both halves of a wheelset need the same step, damping and threads");
  halves_ = std::make_unique<Halves>(model_, step_);
  sides_ = {this, &right};
  if (!model_.second) return;
  const model::Model* const models[] = {&model_, &right.model_};
  second_ = std::make_unique<SecondRolling>(models, step_);
}

void Rolling::startSecond() {
  if (!second_) return;
  std::vector<AlignedVector> filled;
  std::vector<const double*> displaced, velocity;
  for (const auto* side : sides_) filled.push_back(side->displacement());
  for (std::size_t i = 0; i < sides_.size(); ++i)
    displaced.push_back(filled[i].data()), velocity.push_back(sides_[i]->state_.velocity.data());
  second_->start(displaced, velocity);
}

void Rolling::pushSecond() {
  std::array<const double*, 2> displaced{};
  std::array<double*, 2> forces{};
  for (std::size_t i = 0; i < sides_.size(); ++i)
    displaced[i] = sides_[i]->state_.displaced.data(), forces[i] = sides_[i]->forces_.data();
  second_->push(state_.step, {displaced.data(), sides_.size()}, {forces.data(), sides_.size()});
}

// Forces on the sprung mass above the first wheelset are known, and not yet used.
void Rolling::advanceSecond() {
  std::array<double, 2> sprung{};
  const auto force = [](Rolling& side) -> double& {
    const std::size_t auxiliary = side.model_.forceSize - model::auxiliaryUnknowns;
    return side.forces_[auxiliary + side.model_.sprungZ - side.model_.firstAuxiliary];
  };
  for (std::size_t i = 0; i < sides_.size(); ++i) sprung[i] = force(*sides_[i]);
  second_->advance({sprung.data(), sides_.size()});
  for (std::size_t i = 0; i < sides_.size(); ++i) force(*sides_[i]) = sprung[i];
}

// The suspension of both sides along the wheelset's lateral motion, half the difference of what its journals move
// outwards: the vehicle does not follow within a run.
void Rolling::pushLaterally() {
  const auto& other = *sides_[1];
  const auto &left = model_.scenario.suspension, &right = other.model_.scenario.suspension;
  const auto lateral = [&](const AlignedVector& onLeft, const AlignedVector& onRight) {
    return 0.5 * (ringLateralMean(model_, model_.bearing, onLeft.data()) -
                  ringLateralMean(model_, model_.bearing, onRight.data()));
  };
  const double stiffness = left.lateralStiffness + right.lateralStiffness;
  const double damping = left.lateralDamping + right.lateralDamping;
  const double rate = lateral(state_.velocity, other.state_.velocity);
  const double force = stiffness * lateral(state_.displaced, other.state_.displaced) + damping * rate;
  addRingLateralForce(model_, model_.bearing, -0.5 * force, forces_.data());
  addRingLateralForce(model_, model_.bearing, 0.5 * force, sides_[1]->forces_.data());
  halves_->lateralDamperPower = damping * rate * rate;
}

void Rolling::joinAxle(const ThreadShare& own) {
  if (!halves_) return;
  auto& other = sides_[1]->state_;
  for (const auto& part : own.masters) {
    if (part.block != model_.body) continue;
    const auto& body = model_.blocks[part.block];
    const int end = part.first + part.count;
    joinAtCentre(body, halves_->axle, part.first, end, state_.velocity.data(), other.velocity.data());
    joinAtCentre(body, halves_->axle, part.first, end, state_.displaced.data(), other.displaced.data());
    if (part.first > 0) continue;
    for (auto* displaced : {&state_.displaced, &other.displaced}) copyToGhost(body, halves_->axle, displaced->data());
  }
}

void Rolling::joinSleepers(const SleeperShare& sleeper) {
  if (!halves_) return;
  auto& other = sides_[1]->state_;
  const int b = sleeper.stations.front().block;
  const auto& centre = halves_->sleepers[static_cast<std::size_t>(b - model_.firstSleeper)];
  for (const auto& [left, right] : {std::pair{state_.velocity.data(), other.velocity.data()},
                                    std::pair{state_.displaced.data(), other.displaced.data()}})
    joinAtCentre(model_.blocks[b], centre, 0, 1, left, right);
}

// Symmetric and antisymmetric motion have modes of their own, and no energy in common: that of both halves is
// m s^2 + m a^2, twice what the damping of one half reports.
void Rolling::dampBothHalves() {
  // Either kind may have no mode below the limit.
  const bool symmetric = wheelsetDamping_.due(state_.step), antisymmetric = halves_->antisymmetric.due(state_.step);
  if (!symmetric && !antisymmetric) return;
  auto &mean = halves_->mean, &difference = halves_->difference;
  auto &left = state_.velocity, &right = sides_[1]->state_.velocity;
  const auto forWheelset = [&](const auto& work) {
    for (const int b : {model_.rim, model_.body}) {
      const auto& block = model_.blocks[b];
      for (std::size_t i = block.offset; i < block.offset + block.size(); ++i) work(i);
    }
    if (model_.boxOnSpring()) work(model_.boxX), work(model_.boxZ);
  };
  forWheelset([&](std::size_t i) { mean[i] = 0.5 * (left[i] + right[i]), difference[i] = 0.5 * (left[i] - right[i]); });
  double taken = 0;
  if (symmetric) taken += wheelsetDamping_.apply(state_.rotation, mean.data());
  if (antisymmetric) taken += halves_->antisymmetric.apply(state_.rotation, difference.data());
  forWheelset([&](std::size_t i) { left[i] = mean[i] + difference[i], right[i] = mean[i] - difference[i]; });
  for (auto* side : sides_) side->state_.sums.damping += taken;
}

}  // namespace squat::dynamics
