#include "dynamics/SecondRolling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/ElementaryFunctions.h"

namespace squat::dynamics {

namespace {

constexpr double heightSpacing = 1e-3;  // [m] straight between these, far shorter than the patch

// Mean height of the irregularity under a patch of this half length, whose pressure over its length is 1 - t^2.
double heightUnderPatch(const scenario::IrregularSurface& surface, double x, double halfLength) {
  constexpr int points = 15;
  double sum = 0, weights = 0;
  for (int i = 0; i < points; ++i) {
    const double t = (2 * i + 1.0) / points - 1, weight = 1 - t * t;
    sum += weight * surface.height(x + t * halfLength), weights += weight;
  }
  return sum / weights;
}

}  // namespace

SecondRolling::SecondRolling(std::span<const model::Model* const> sides, double step)
    : models_(sides.begin(), sides.end()), step_(step) {
  const auto& model = *models_.front();
  const auto& d = model.scenario;
  pitch_ = std::pow(0.5 * d.bogie.wheelbase / d.bogie.pitchRadius, 2);
  const double rate = d.motion.speed / model.surfaces.radius;
  for (const auto& motions : model::secondMotions(d)) {
    Kind kind{motions.rigidMass, motions.boxLever, {}};
    for (const auto& mode : motions.modes) {
      const double omega = 2 * std::numbers::pi * mode.frequency;
      const bool isDamped = mode.frequency < d.wheelset.dampingLimit;
      Mode own;
      own.omega2 = omega * omega, own.damping = isDamped ? 2 * d.wheelset.dampingRatio * omega : 0;
      own.contact = mode.contactAmplitude, own.box = mode.boxAmplitude;
      own.turn = (mode.harmonic - mode.stays) * rate;
      own.cosine = elementary::cos(own.turn * step_), own.sine = elementary::sin(own.turn * step_);
      kind.modes.push_back(own);
    }
    motions_.push_back({0, 0, std::vector<Pair>(kind.modes.size())});
    kinds_.push_back(std::move(kind));
  }
  for (const auto* side : models_) seats_.emplace_back(*side);
  sides_.resize(models_.size()), views_.resize(models_.size()), boxBefore_.resize(models_.size());
  layHeights();
}

void SecondRolling::layHeights() {
  const auto& model = *models_.front();
  const auto& motion = model.scenario.motion;
  constexpr double margin = 0.01, wait = 2e-3;  // [m], [s] the run goes on for what the filters of its signals need
  heightsFrom_ = model.startX + model.second->offset - margin;
  const double way = motion.runUp + motion.beyond + 2 * margin + wait * motion.speed;
  const auto count = static_cast<int>(way / heightSpacing) + 2;
  for (const auto* side : models_) {
    auto& heights = heights_.emplace_back();
    const auto& surface = side->scenario.irregularityUnderSecond;
    if (surface.isSmooth()) continue;
    for (int i = 0; i < count; ++i)
      heights.push_back(heightUnderPatch(surface, heightsFrom_ + i * heightSpacing, model.second->halfLength));
  }
}

double SecondRolling::placeAt(long step) const {
  const auto& model = *models_.front();
  return model.startX + model.second->offset + model.scenario.motion.speed * static_cast<double>(step) * step_;
}

// The seat stands at x.
double SecondRolling::heightBelow(std::size_t side, double x, const double* displaced) const {
  const double mean = seats_[side].mean(displaced);
  const auto& heights = heights_[side];
  if (heights.empty()) return mean;
  const double at = std::clamp((x - heightsFrom_) / heightSpacing, 0.0, static_cast<double>(heights.size() - 2));
  const auto i = static_cast<std::size_t>(at);
  return mean + heights[i] + (at - static_cast<double>(i)) * (heights[i + 1] - heights[i]);
}

double SecondRolling::part(std::size_t kind, double left, double right) const {
  if (models_.size() == 1) return left;
  return 0.5 * (kind == 0 ? left + right : left - right);
}

template <typename Of>
double SecondRolling::sumOver(std::size_t side, const Of& of) const {
  double sum = 0;
  for (std::size_t k = 0; k < kinds_.size(); ++k) sum += sign(k, side) * of(kinds_[k], motions_[k]);
  return sum;
}

double SecondRolling::wheel(std::size_t side) const {
  return sumOver(side, [](const Kind& kind, const Motion& motion) {
    double sum = motion.rigid;
    for (std::size_t i = 0; i < kind.modes.size(); ++i) sum += kind.modes[i].contact * motion.pairs[i].q[0];
    return sum;
  });
}

double SecondRolling::box(std::size_t side) const {
  return sumOver(side, [](const Kind& kind, const Motion& motion) {
    double sum = kind.boxLever * motion.rigid;
    for (std::size_t i = 0; i < kind.modes.size(); ++i) sum += kind.modes[i].box * motion.pairs[i].q[0];
    return sum;
  });
}

double SecondRolling::wheelVelocity(std::size_t side) const {
  return sumOver(side, [](const Kind& kind, const Motion& motion) {
    double sum = motion.rigidVelocity;
    for (std::size_t i = 0; i < kind.modes.size(); ++i) {
      const auto& mode = kind.modes[i];
      sum += mode.contact * (motion.pairs[i].p[0] - mode.turn * motion.pairs[i].q[1]);
    }
    return sum;
  });
}

double SecondRolling::boxVelocity(std::size_t side) const {
  return sumOver(side, [](const Kind& kind, const Motion& motion) {
    double sum = kind.boxLever * motion.rigidVelocity;
    for (std::size_t i = 0; i < kind.modes.size(); ++i) {
      const auto& mode = kind.modes[i];
      sum += mode.box * (motion.pairs[i].p[0] - mode.turn * motion.pairs[i].q[1]);
    }
    return sum;
  });
}

SecondVelocities SecondRolling::velocities(std::size_t side) const {
  return {wheelVelocity(side), boxVelocity(side), sides_[side].sprungVelocity};
}

void SecondRolling::start(std::span<const double* const> displaced, std::span<const double* const> velocity) {
  const auto& d = models_.front()->scenario;
  const double x = placeAt(0), speed = d.motion.speed;
  std::vector<const scenario::Scenario*> scenarios;
  for (const auto* model : models_) scenarios.push_back(&model->scenario);
  const auto loads = model::secondLoads(scenarios);
  std::vector<double> height, rate;  // of the wheels
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    auto& seat = seats_[i];
    const auto heightAt = [&](double place) {
      seat.moveTo(place);
      return heightBelow(i, place, displaced[i]);
    };
    constexpr double aside = 1e-3;  // [m] within an element
    const double slope = (heightAt(x + aside) - heightAt(x - aside)) / (2 * aside);
    height.push_back(heightAt(x) - models_.front()->second->approach(loads[i]));
    rate.push_back(seat.mean(velocity[i]) + speed * slope);
    sides_[i].force = loads[i];
    sides_[i].suspension = -d.motion.gravity * models_[i]->scenario.suspension.sprungMass;
  }
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    auto& motion = motions_[k];
    const double force = part(k, sides_.front().force, sides_.back().force);
    const double suspension = part(k, sides_.front().suspension, sides_.back().suspension);
    motion.rigid = part(k, height.front(), height.back());
    motion.rigidVelocity = part(k, rate.front(), rate.back());
    for (std::size_t i = 0; i < motion.pairs.size(); ++i) {
      const auto& mode = kinds_[k].modes[i];
      auto& pair = motion.pairs[i];
      pair.q[0] = (mode.contact * force + mode.box * suspension) / (mode.omega2 - mode.turn * mode.turn);
      pair.p[1] = -mode.turn * pair.q[0];
      motion.rigid -= mode.contact * pair.q[0];
    }
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    sides_[i].sprung = box(i) + sides_[i].suspension / models_[i]->scenario.suspension.stiffness;
    sides_[i].sprungVelocity = boxVelocity(i);
    views_[i] = {0, loads[i]};
  }
}

void SecondRolling::push(long step, std::span<const double* const> displaced, std::span<double* const> forces) {
  const double before = placeAt(step - 1), x = placeAt(step), hertz = models_.front()->second->hertz;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    auto& seat = seats_[i];
    seat.moveTo(before);
    const double heightBehind = heightBelow(i, before, displaced[i]);
    seat.moveTo(x);
    const double height = heightBelow(i, x, displaced[i]);
    const double approach = std::max(0.0, height - wheel(i));
    sides_[i].force = hertz * approach * std::sqrt(approach);
    seat.addToForces(-sides_[i].force, forces[i]);
    driven_ += sides_[i].force * (height - heightBehind);
  }
}

void SecondRolling::advance(std::span<double> sprung) {
  const double g = models_.front()->scenario.motion.gravity;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    auto& side = sides_[i];
    const auto& suspension = models_[i]->scenario.suspension;
    const double rate = side.sprungVelocity - boxVelocity(i);
    side.suspension = suspension.stiffness * (side.sprung - box(i)) + suspension.damping * rate;
    damped_ += step_ * suspension.damping * rate * rate;
    boxBefore_[i] = boxVelocity(i);
  }
  for (std::size_t k = 0; k < kinds_.size(); ++k) advanceMotion(k);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    auto& side = sides_[i];
    const double above = -side.suspension, mean = 0.5 * (sprung[i] + above), half = 0.5 * (sprung[i] - above);
    sprung[i] = mean + pitch_ * half;
    side.sprungVelocity += step_ * ((mean - pitch_ * half) / models_[i]->scenario.suspension.sprungMass - g);
    side.sprung += step_ * side.sprungVelocity;
    views_[i] = {(boxVelocity(i) - boxBefore_[i]) / step_, side.force};
  }
}

void SecondRolling::advanceMotion(std::size_t k) {
  const auto& kind = kinds_[k];
  auto& motion = motions_[k];
  const double force = part(k, sides_.front().force, sides_.back().force);
  const double suspension = part(k, sides_.front().suspension, sides_.back().suspension);
  const double gravity = k == 0 ? models_.front()->scenario.motion.gravity : 0;
  motion.rigidVelocity += step_ * ((force + kind.boxLever * suspension) / kind.mass - gravity);
  motion.rigid += step_ * motion.rigidVelocity;
  for (std::size_t i = 0; i < kind.modes.size(); ++i) {
    const auto& mode = kind.modes[i];
    auto& [q, p] = motion.pairs[i];
    const double rate[2] = {p[0] - mode.turn * q[1], p[1] + mode.turn * q[0]};
    const double pushed[2] = {mode.contact * force + mode.box * suspension, 0};
    // The forces have the power F P on the energy of Q and P; contact and springs account for F dQ/dt of it, and what
    // turns the wheelset gives the rest. In the same way dampers take 2 zeta omega P dQ/dt.
    const double halves = static_cast<double>(sides_.size());
    driven_ += halves * step_ * pushed[0] * mode.turn * q[1];
    for (int c = 0; c < 2; ++c) {
      damped_ += halves * step_ * mode.damping * rate[c] * p[c];
      p[c] += step_ * (pushed[c] - mode.omega2 * q[c] - mode.damping * rate[c]);
      q[c] += step_ * p[c];
    }
    for (auto* v : {q, p}) {
      const double cosine = mode.cosine * v[0] - mode.sine * v[1];
      v[1] = mode.sine * v[0] + mode.cosine * v[1], v[0] = cosine;
    }
  }
}

double SecondRolling::kineticEnergy(std::span<const double> sprungVelocity) const {
  double sum = 0;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    double own = kinds_[k].mass * motions_[k].rigidVelocity * motions_[k].rigidVelocity;
    for (const auto& pair : motions_[k].pairs) own += pair.p[0] * pair.p[0] + pair.p[1] * pair.p[1];
    sum += 0.5 * own * static_cast<double>(sides_.size());
  }
  // Of the common body: m/2 (1 + 1/p)(v1^2 + v2^2)/2 + m/2 (1 - 1/p) v1 v2, p the coupling.
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double mass = models_[i]->scenario.suspension.sprungMass;
    const double first = sprungVelocity[i], second = sides_[i].sprungVelocity;
    sum += 0.25 * mass * ((1 + 1 / pitch_) * (first * first + second * second)) +
           0.5 * mass * (1 - 1 / pitch_) * first * second - 0.5 * mass * first * first;
  }
  return sum;
}

double SecondRolling::strainEnergy() const {
  double sum = 0;
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    for (std::size_t i = 0; i < motions_[k].pairs.size(); ++i) {
      const auto& q = motions_[k].pairs[i].q;
      sum += 0.5 * static_cast<double>(sides_.size()) * kinds_[k].modes[i].omega2 * (q[0] * q[0] + q[1] * q[1]);
    }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double stretch = sides_[i].sprung - box(i);
    sum += 0.5 * models_[i]->scenario.suspension.stiffness * stretch * stretch;
  }
  return sum;
}

double SecondRolling::workOfWeight() const {
  const auto& first = models_.front()->scenario;
  double sum = -first.wheelset.totalMass * motions_.front().rigid * static_cast<double>(sides_.size());
  for (std::size_t i = 0; i < sides_.size(); ++i) sum -= models_[i]->scenario.suspension.sprungMass * sides_[i].sprung;
  return first.motion.gravity * sum;
}

double SecondRolling::contactEnergy() const {
  double sum = 0;
  for (const auto& side : sides_) sum += 0.4 * side.force * models_.front()->second->approach(side.force);
  return sum;
}

std::vector<double> SecondRolling::packed() const {
  std::vector<double> values{damped_, driven_};
  for (const auto& motion : motions_) {
    values.insert(values.end(), {motion.rigid, motion.rigidVelocity});
    for (const auto& pair : motion.pairs) values.insert(values.end(), {pair.q[0], pair.q[1], pair.p[0], pair.p[1]});
  }
  for (const auto& side : sides_)
    values.insert(values.end(), {side.sprung, side.sprungVelocity, side.force, side.suspension});
  return values;
}

void SecondRolling::unpack(std::span<const double> values) {
  auto at = values.begin();
  const auto take = [&](auto&... numbers) { ((numbers = *at++), ...); };
  take(damped_, driven_);
  for (auto& motion : motions_) {
    take(motion.rigid, motion.rigidVelocity);
    for (auto& pair : motion.pairs) take(pair.q[0], pair.q[1], pair.p[0], pair.p[1]);
  }
  for (auto& side : sides_) take(side.sprung, side.sprungVelocity, side.force, side.suspension);
  for (std::size_t i = 0; i < sides_.size(); ++i) views_[i] = {0, sides_[i].force};
}

}  // namespace squat::dynamics
