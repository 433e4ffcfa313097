#include "dynamics/Rolling.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/ElementaryFunctions.h"
#include "dynamics/RollingHalves.h"
#include "model/BuildForceElements.h"

namespace squat::dynamics {

namespace {

// In the precision that the case asks for: all blocks but the wheel body. Rounding acts like forces of 6e-8 times
// stiffness times displacement; in the coarse sectors of the wheel body, whose own motion says little about the nodes
// far from its middle, these have a resultant that works on the rolling itself, and the energy drifts.
elasticity::KernelSet kernelsAsAsked(const model::Model& model, const std::string& isa) {
  const bool single = model.scenario.mesh.precision == scenario::ElementPrecision::single;
  return elasticity::kernelsFor(isa,
                                single ? elasticity::Precision::singleInside : elasticity::Precision::doubleInside);
}

// Gravity in the local components of every station; `drift` [m/s2] is added to it where the block turns.
void fillGravity(const elasticity::SweptBlock& block, double gravity, const model::TurnedStations* turned,
                 const model::PlaneVector& drift, AlignedVector& lines) {
  for (int s = 0; s < block.stationCount; ++s) {
    switch (block.kind) {
      case elasticity::SweepKind::alongX:
        lines[block.stride + s] = -gravity * elementary::sin(block.lean);
        lines[2 * block.stride + s] = -gravity * elementary::cos(block.lean);
        break;
      case elasticity::SweepKind::alongY:
        lines[block.stride + s] = -gravity;
        break;
      case elasticity::SweepKind::aroundAxis:
        lines[s] = drift.x * turned->cosine[s] + (drift.z - gravity) * turned->sine[s];
        lines[block.stride + s] = drift.x * turned->sine[s] - (drift.z - gravity) * turned->cosine[s];
        break;
    }
  }
}

}  // namespace

Rolling::Rolling(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double step,
                 double beta)
    : model_(model),
      kernels_(kernels),
      askedKernels_(kernelsAsAsked(model, kernels.name)),
      team_(team),
      step_(step),
      beta_(beta),
      contact_(model, step, beta),
      wheelsetDamping_(model, step),
      pace_(firstGuessOfOtherWork(model, team.size())),
      shares_(shareStep(model, pace_.otherWork())),
      oneShare_(shareStep(model, {0.0})) {
  const auto& d = model.scenario;
  load_ = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
  layerKernels_ = plasticity::layerKernelsFor(kernels.name);
  for (int i = 0; i < team.size(); ++i) scratch_.push_back(std::make_unique<elasticity::KernelScratch>(model.blocks));
  forces_.assign(model.forceSize, 0.0);
  turnStations(model.blocks[model.body], 0, turned_);
  turnStations(model.blocks[model.rim], 0, turnedRim_);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    acceleration_.emplace_back(3 * block.stride, 0.0);
    fillGravity(block, d.motion.gravity, static_cast<int>(b) == model.rim ? &turnedRim_ : &turned_, {},
                acceleration_.back());
    radii_.emplace_back();
    if (block.kind == elasticity::SweepKind::aroundAxis)
      for (const auto& p : block.section.nodes) radii_.back().push_back(p[0]);
  }
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    elasticity::BlockStep with;
    with.kernels = static_cast<int>(b) == model.body ? &kernels_ : &askedKernels_;
    inverseMass_.push_back(elasticity::inChunks(block, model.inverseMass[b].data()));
    with.inverseMass = inverseMass_.back().data();
    with.freeMask = model.freeMask[b].data();
    with.lineOfNode = model.loaded[b].lineOfNode.data();
    evenInverse_.push_back(elasticity::evenInverseMass(block, model.inverseMass[b].data(), with.lineOfNode));
    with.evenInverse = evenInverse_.back().data();
    with.slave = model.slave[b].data();
    with.force = forces_.data() + model.loaded[b].offset;
    // Along a line gravity is the same everywhere; what is fixed there is fixed after each step (fix()).
    if (block.kind == elasticity::SweepKind::aroundAxis)
      with.acceleration = acceleration_[b].data();
    else
      for (int c = 0; c < 3; ++c) with.evenAcceleration[c] = acceleration_[b][c * block.stride];
    with.radialWeight = radii_[b].empty() ? nullptr : radii_[b].data();
    with.beta = beta;
    blockSteps_.push_back(with);
  }
  for (const auto& [index, b] : {std::pair{0, model.rim}, std::pair{1, model.body}}) {
    turningMoment_[index].assign(model.blocks[b].stride, 0.0);
    blockSteps_[b].turningMoment = turningMoment_[index].data();
  }
  std::size_t largestTie = 0;
  for (const auto& tie : model.ties) largestTie = std::max(largestTie, elasticity::tieWorkspace(tie));
  tieWorkspaces_.assign(static_cast<std::size_t>(team.size()), AlignedVector(largestTie, 0.0));
  groupDamperPowers_.assign(shares_.forceGroups, 0.0);
  if (model.second && model.scenario.extent == scenario::ModelExtent::half) {
    const model::Model* const sides[] = {&model};
    second_ = std::make_unique<SecondRolling>(sides, step);
  }
}

void Rolling::start(const AlignedVector& displacement, const AlignedVector& velocity, double angularVelocity) {
  state_ = {};
  state_.velocity = velocity;
  state_.displaced = displacement;
  for (std::size_t i = 0; i < velocity.size(); ++i) state_.displaced[i] += beta_ * velocity[i];
  state_.angularVelocity = angularVelocity;
  state_.friction.traction.assign(2 * model_.surfaces.points(), 0.0);
  state_.plastic = plasticity::restState(model_.layer);
  restore(std::move(state_));
}

void Rolling::restore(RollingState state) {
  state_ = std::move(state);
  contact_.restart(state_.step);
  fix(model_.fixed);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  layerForces_ = plasticity::layerForces(model_.layer, layerKernels_, state_.plastic);
  turnStations(model_.blocks[model_.body], state_.rotation, turned_);
  view_ = {};
  boxVelocity_ = boxVelocity(), boxLateralVelocity_ = boxLateralVelocity();
  wheelVelocity_ = ringMean(model_, model_.centre, turned_, state_.velocity.data());
  const auto wheel = wheelRolling(state_.displaced.data());
  view_.step = state_.step, view_.time = state_.time;
  view_.position = positionOf(wheel);
  view_.angularVelocity = state_.angularVelocity;
}

double Rolling::torqueAt(double time) const {
  const auto& m = model_.scenario.motion;
  const double full = m.tractionCoefficient != 0 ? m.tractionCoefficient * load_ * model_.surfaces.radius : m.torque;
  if (time >= m.torqueRamp) return full;
  return full * 0.5 * (1 - elementary::cos(std::numbers::pi * time / m.torqueRamp));
}

contact::WheelRolling Rolling::wheelRolling(const double* displaced) const {
  const auto& d = model_.scenario;
  const auto hub = ringMean(model_, model_.centre, turned_, displaced);
  contact::WheelRolling wheel;
  // Displacements u + beta v are those of a moment later: so must be the wheel's location.
  wheel.placement = {model_.startX + d.motion.speed * (state_.time + beta_),
                     model_.wheelset.centreHeight,
                     state_.rotation,
                     hub.x,
                     hub.z,
                     state_.angularVelocity * beta_};
  wheel.speed = d.motion.speed;
  wheel.angularVelocity = state_.angularVelocity;
  return wheel;
}

// At the instant of view_.time: the placement is beta later.
double Rolling::positionOf(const contact::WheelRolling& wheel) const {
  return wheel.placement.centreX + wheel.placement.hubX - wheel.speed * beta_;
}

void Rolling::evaluateContact() {
  const auto wheel = wheelRolling(state_.displaced.data());
  view_.step = state_.step;
  view_.time = state_.time;
  view_.position = positionOf(wheel);
  view_.patch = contact_.evaluate(wheel, state_, forces_.data());
  addedAngularVelocity_ = contact_.inertia().addedAngularVelocity(state_.velocity.data(), 1, 0);
}

// Of rail (0) or rim (1), once the contact is known and before the first of its stations is advanced.
void Rolling::addContactInertia(int body) {
  const int b = body == 0 ? model_.rail : model_.rim;
  auto& inertia = contact_.inertia();
  inertia.apply(body, inverseMass_[b].data());
  blockSteps_[b].ownFilter = inertia.ownFilter(body), blockSteps_[b].filters = inertia.filters(body);
}

model::PlaneVector Rolling::boxVelocity() const {
  const double* v = state_.velocity.data();
  if (model_.boxOnSpring()) return {v[model_.boxX], v[model_.boxZ]};
  return ringMean(model_, model_.bearing, turned_, v);
}

// The box has no play along the axle.
double Rolling::boxLateralVelocity() const { return ringLateralMean(model_, model_.bearing, state_.velocity.data()); }

// The torque acts evenly on the hub, against alpha.
void Rolling::applyHubForce() {
  torque_ = torqueAt(state_.time);
  const auto& body = model_.blocks[model_.body];
  const auto& loaded = model_.loaded[model_.body];
  hubAngularVelocity_ = 0;
  for (std::size_t i = 0; i < model_.hub.nodes.size(); ++i) {
    const int node = model_.hub.nodes[i];
    const double radius = body.section.nodes[node][0], share = model_.hub.weight[i] / body.stationCount;
    double* a = forces_.data() + loaded.offset + static_cast<std::size_t>(loaded.lineOfNode[node]) * 3 * body.stride;
    const auto va = body.line(std::as_const(state_.velocity).data(), node, 0);
    for (int s = 0; s < body.stationCount; ++s)
      a[s] -= torque_ * share / radius, hubAngularVelocity_ -= share * va[s] / radius;
  }
}

void Rolling::pushWheelset() {
  turnStations(model_.blocks[model_.body], state_.rotation, turned_);
  turnStations(model_.blocks[model_.rim], state_.rotation, turnedRim_);
  evaluateContact();
  // On the contact's own lines.
  elasticity::addIrregularForces(model_.movedElements, state_.displaced.data(), forces_.data());
  applyHubForce();
  for (auto* state : {&state_.displaced, &state_.velocity}) followJournal(model_, turned_, state->data());
}

void Rolling::pushSides() {
  Turning all;
  for (auto* side : sides_) {
    side->pushWheelset();
    all.outer += side->torque_ + side->view_.patch.rotationMoment + side->state_.addedMoment;
    all.inner += side->state_.turningMoment;
    all.inertia += side->model_.wheelset.inertia;
  }
  for (auto* side : sides_) side->turn(all);
  if (halves_) pushLaterally();
  if (second_) pushSecond();
}

void Rolling::turn(const Turning& all) {
  const auto& w = model_.wheelset;
  referenceAcceleration_ = all.outer / all.inertia;
  angularAcceleration_ = referenceAcceleration_ + all.inner / all.inertia;
  // The reference turns about its centre of mass.
  const double share = -referenceAcceleration_ / w.turningMass, c = elementary::cos(state_.rotation),
               s = elementary::sin(state_.rotation);
  const model::PlaneVector drift{share * (c * w.leverX + s * w.leverZ), share * (c * w.leverZ - s * w.leverX)};
  const double g = model_.scenario.motion.gravity;
  fillGravity(model_.blocks[model_.body], g, &turned_, drift, acceleration_[model_.body]);
  fillGravity(model_.blocks[model_.rim], g, &turnedRim_, drift, acceleration_[model_.rim]);
  const double rate = state_.angularVelocity + step_ * angularAcceleration_;
  for (const int b : {model_.rim, model_.body}) {
    blockSteps_[b].angularAcceleration = referenceAcceleration_;
    blockSteps_[b].cosine = elementary::cos(rate * step_);
    blockSteps_[b].sine = elementary::sin(rate * step_);
  }
}

void Rolling::fix(const std::vector<std::size_t>& unknowns) {
  for (const auto index : unknowns) state_.velocity[index] = 0, state_.displaced[index] = 0;
}

void Rolling::finishStep() {
  double* displaced = state_.displaced.data();
  const auto& d = model_.scenario;
  double* v = state_.velocity.data();
  double* auxiliary = forces_.data() + model_.forceSize - model::auxiliaryUnknowns;
  const auto advance = [&](std::size_t index, double mass, double gravity) {
    const double acceleration = auxiliary[index - model_.firstAuxiliary] / mass - gravity;
    const double old = v[index];
    v[index] = old + step_ * acceleration;
    displaced[index] = displaced[index] - beta_ * old + (step_ + beta_) * v[index];
    auxiliary[index - model_.firstAuxiliary] = 0;
  };
  advance(model_.sprungX, d.suspension.sprungMass, 0);
  advance(model_.sprungZ, d.suspension.sprungMass, d.motion.gravity);
  if (model_.boxOnSpring()) {
    advance(model_.boxX, d.wheelset.axleBoxMass, 0);
    advance(model_.boxZ, d.wheelset.axleBoxMass, d.motion.gravity);
  }

  const double oldRate = state_.angularVelocity;
  state_.angularVelocity += step_ * angularAcceleration_;
  state_.rotation += step_ * state_.angularVelocity;
  state_.turningMoment = 0;
  for (auto& line : turningMoment_)
    for (double& moment : line) state_.turningMoment += std::exchange(moment, 0.0);
  const auto& turn = blockSteps_[model_.rim];
  state_.addedMoment =
      (contact_.inertia().addedAngularVelocity(v, turn.cosine, turn.sine) - addedAngularVelocity_) / step_ -
      referenceAcceleration_ * contact_.inertia().addedInertia();
  ++state_.step;
  state_.time = static_cast<double>(state_.step) * step_;
  state_.sums.friction += step_ * view_.patch.frictionPower;
  state_.sums.damping += step_ * damperPower_;
  if (halves_) state_.sums.damping += step_ * halves_->lateralDamperPower;
  state_.sums.torqueWork += step_ * torque_ * (0.5 * (oldRate + state_.angularVelocity) + hubAngularVelocity_);

  turnStations(model_.blocks[model_.body], state_.rotation, turned_);
  view_.angularVelocity = 0.5 * (oldRate + state_.angularVelocity);
}

// The new velocities stand in the basis of the new rotation.
void Rolling::finishSides() {
  if (second_) advanceSecond();
  for (auto* side : sides_) side->finishStep();
  if (halves_)
    dampBothHalves();
  else if (wheelsetDamping_.due(state_.step))
    dampWheelset();
  for (auto* side : sides_) side->takeAccelerations();
  if (second_)
    for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i]->view_.second = second_->view(i);
}

void Rolling::dampWheelset() { state_.sums.damping += wheelsetDamping_.apply(state_.rotation, state_.velocity.data()); }

void Rolling::takeAccelerations() {
  const auto box = boxVelocity();
  const auto wheel = ringMean(model_, model_.centre, turned_, state_.velocity.data());
  view_.boxAcceleration = {(box.x - boxVelocity_.x) / step_, (box.z - boxVelocity_.z) / step_};
  view_.wheelAcceleration = {(wheel.x - wheelVelocity_.x) / step_, (wheel.z - wheelVelocity_.z) / step_};
  boxVelocity_ = box, wheelVelocity_ = wheel;
  if (model_.scenario.extent == scenario::ModelExtent::half) return;
  const double lateral = boxLateralVelocity();
  view_.boxLateralAcceleration = (lateral - boxLateralVelocity_) / step_;
  boxLateralVelocity_ = lateral;
}

AlignedVector Rolling::displacement() const {
  AlignedVector u;
  displacement(u);
  return u;
}

void Rolling::displacement(AlignedVector& u) const {
  u = state_.displaced;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] -= beta_ * state_.velocity[i];
  elasticity::refreshGhosts(model_.blocks, u.data());
  AlignedVector workspace(tieWorkspaces_.front().size(), 0.0);
  for (const auto& tie : model_.ties) interpolateSlaves(tie, model_.blocks, u.data(), workspace.data());
  followJournal(model_, turned_, u.data());
}

std::vector<contact::PatchPoint> Rolling::patchPoints() const {
  return contact_.points(wheelRolling(state_.displaced.data()), state_);
}

double Rolling::frontOfContact(double margin) const {
  return contact_.front(margin, wheelRolling(state_.displaced.data()), state_);
}

}  // namespace squat::dynamics
