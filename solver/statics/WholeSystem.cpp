#include "statics/WholeSystem.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace squat::statics {

namespace {

using Terms = std::vector<std::pair<std::size_t, double>>;

// Half of the left side's, and of the right side's with its sign.
Terms meanOf(const Terms& terms, std::size_t rightOffset, double sign) {
  Terms mean;
  for (const auto& [unknown, weight] : terms) {
    mean.push_back({unknown, 0.5 * weight});
    mean.push_back({rightOffset + unknown, 0.5 * sign * weight});
  }
  return mean;
}

}  // namespace

WholeSystem::WholeSystem(const model::Model& left, const model::Model& right, const elasticity::KernelSet& kernels,
                         ThreadTeam& team, double rotation)
    : StaticSystem(team, rotation), kernels_(kernels) {
  if (!haveLikeUnknowns(left, right))
    throw std::invalid_argument("both halves of a whole model need meshes with the same unknowns");
  constexpr std::size_t line = 8;  // numbers of a cache line, at which kernels want a state to begin
  const std::size_t offset = (left.stateSize + line - 1) / line * line;
  for (const auto& [model, at] : {std::pair{&left, std::size_t{0}}, std::pair{&right, offset}})
    halves_.push_back({*model, std::make_unique<model::StaticOperator>(*model, kernels, team, rotation, 0, true), at});
  centre_.push_back(axleCentre(left));
  for (int i = 0; i < left.sleepers; ++i) centre_.push_back(sleeperCentre(left, left.firstSleeper + i));
  const Terms turn = model::hubTurn(left), lateral = model::ringLateral(left, left.bearing);
  // Both halves of a half model's spring.
  between_.add(meanOf(turn, offset, 1), 2 * rotationStiffness, 0);
  // Both suspensions along the wheelset's lateral motion.
  for (const auto* terms : {&turn, &lateral})
    for (const auto& term : *terms) coupled_.push_back(term.first);
  between_.add(meanOf(lateral, offset, -1),
               left.scenario.suspension.lateralStiffness + right.scenario.suspension.lateralStiffness, 0);
}

std::unique_ptr<StaticSystem> WholeSystem::turnedBy(double rotation) const {
  return std::make_unique<WholeSystem>(halves_[0].model, halves_[1].model, kernels_, team_, rotation_ + rotation);
}

void WholeSystem::joinAs(const model::CentreNodes& centre, double* state) const {
  const auto& block = halves_[0].model.blocks[centre.block];
  const bool isAxle = centre.block == halves_[0].model.body;
  joinAtCentre(block, centre, 0, isAxle ? block.stationCount : 1, state, rightOf(state));
}

void WholeSystem::join(double* state) const {
  for (const auto& centre : centre_) joinAs(centre, state);
}

void WholeSystem::apply(double* u, double* result) {
  halves_[0].op->apply(u, result);
  halves_[1].op->apply(rightOf(u), rightOf(result));
  forces::addStiffness(between_, u, result);
  join(result);
}

// Unknowns that are one have one diagonal.
AlignedVector WholeSystem::inverseDiagonal() const {
  AlignedVector inverse(size(), 0.0);
  for (const auto& half : halves_) {
    const auto own = half.op->diagonal();
    std::copy(own.begin(), own.end(), inverse.begin() + static_cast<std::ptrdiff_t>(half.offset));
  }
  forces::addDiagonal(between_, inverse.data());
  for (auto centre : centre_) {
    centre.sign = {1, 1, 1};
    joinAs(centre, inverse.data());
  }
  for (const auto& half : halves_) {
    const auto& free = half.op->freeUnknowns();
    for (std::size_t i = 0; i < free.size(); ++i) {
      double& value = inverse[half.offset + i];
      value = free[i] ? 1 / value : 0;
    }
  }
  return inverse;
}

double WholeSystem::energyBetween(const double* u) const {
  double sum = 0;
  for (std::size_t i = 0; i < between_.size(); ++i) {
    const double elongation = between_.elongation(i, u);
    sum += 0.5 * between_.stiffness[i] * elongation * elongation;
  }
  return sum;
}

WholeSystem::Kind::Kind(const model::Model& half, model::Centre centre)
    : model(half), sign(centre == model::Centre::symmetric ? 1 : -1) {
  model::fixUnknowns(model, centre);
  held = model.fixed;
  const auto& body = model.blocks[model.body];
  for (int n = 0; n < body.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      if (model.freeMask[model.body][3 * n + c] == 0)
        for (int s = 0; s < body.stationCount; ++s) held.push_back(body.index(n, c, s));
}

void WholeSystem::applyToKind(const Kind& kind, double* u, double* result) {
  for (const std::size_t index : kind.held) u[index] = 0;
  const std::size_t n = kind.model.stateSize;
  double *left = both_.data(), *right = rightOf(both_.data());
  for (std::size_t i = 0; i < n; ++i) left[i] = u[i], right[i] = kind.sign * u[i];
  apply(both_.data(), pushed_.data());
  const double *onLeft = pushed_.data(), *onRight = rightOf(pushed_.data());
  for (std::size_t i = 0; i < n; ++i) result[i] = onLeft[i] + kind.sign * onRight[i];
}

bool WholeSystem::reachesCentre(const double* u, const double* result) const {
  const auto moves = [u](std::size_t index) { return u[index] != 0; };
  const auto isFelt = [&](std::size_t index) { return u[index] != 0 || result[index] != 0; };
  return std::any_of(coupled_.begin(), coupled_.end(), moves) ||
         std::any_of(kinds_.begin(), kinds_.end(),
                     [&](const auto& kind) { return std::any_of(kind->held.begin(), kind->held.end(), isFelt); });
}

// Of hats that do not reach the centre, both kinds have the same columns: the antisymmetric kind takes them from the
// symmetric one.
bool WholeSystem::assemble(Monitor& monitor) {
  std::array<forces::ForceElements, 2> kept;
  for (std::size_t i = 0; i < 2; ++i) kept[i] = std::exchange(halves_[i].op->contactSprings(), {});
  both_.assign(size(), 0.0), pushed_.assign(size(), 0.0);
  for (const auto& [kind, centre] :
       {std::pair{0, model::Centre::symmetric}, std::pair{1, model::Centre::antisymmetric}}) {
    kinds_[kind] = std::make_unique<Kind>(halves_[0].model, centre);
    kinds_[kind]->coarse.emplace(kinds_[kind]->model, *halves_[0].op);
  }
  std::vector<bool> isSame;
  AlignedVector asked;
  const auto product = [&](const Kind& kind) {
    return [&](double* u, double* result) {
      asked.assign(u, u + kind.model.stateSize);
      applyToKind(kind, u, result);
      if (&kind == kinds_[0].get()) isSame.push_back(!reachesCentre(asked.data(), result));
      for (const std::size_t index : kind.held) result[index] = 0;
    };
  };
  const CoarseSpace::Known known{*kinds_[0]->coarse, isSame};
  const bool isDone = kinds_[0]->coarse->assemble(team_, product(*kinds_[0]), monitor) &&
                      kinds_[1]->coarse->assemble(team_, product(*kinds_[1]), monitor, &known);
  for (std::size_t i = 0; i < 2; ++i) halves_[i].op->contactSprings() = std::move(kept[i]);
  both_ = {}, pushed_ = {};
  return isDone;
}

void WholeSystem::factorise() {
  const std::array<const forces::ForceElements*, 2> contacts{&halves_[0].op->contactSprings(),
                                                             &halves_[1].op->contactSprings()};
  for (auto& kind : kinds_) kind->coarse->factorise(contacts);
}

// Symmetric motions answer to the sum of the forces on both sides, antisymmetric ones to their difference.
CoarseSpace::Correction WholeSystem::correctionOf(const double* r) const {
  const auto& coarse = *kinds_[0]->coarse;  // the hats of both kinds are the same
  const auto left = coarse.resultantsOf(team_, r), right = coarse.resultantsOf(team_, rightOf(r));
  const auto symmetric = kinds_[0]->coarse->correctionOf(left + right);
  const auto antisymmetric = kinds_[1]->coarse->correctionOf(left - right);
  CoarseSpace::Correction both{Eigen::VectorXd(symmetric.y.size() + antisymmetric.y.size()),
                               symmetric.product + antisymmetric.product};
  both.y << symmetric.y, antisymmetric.y;
  return both;
}

// The kinds differ only where they meet the centre: rail and rim take both at once.
void WholeSystem::prolong(const Eigen::VectorXd& y, double* z) const {
  using enum CoarseSpace::Bodies;
  const Eigen::Index count = kinds_[0]->coarse->size();
  const Eigen::VectorXd symmetric = y.head(count), antisymmetric = y.tail(count);
  kinds_[0]->coarse->prolong(team_, symmetric + antisymmetric, z, railAndRim);
  kinds_[0]->coarse->prolong(team_, symmetric - antisymmetric, rightOf(z), railAndRim);
  std::vector<double> kept;
  for (const auto& kind : kinds_)
    for (double* side : {z, rightOf(z)}) {
      kept.clear();
      for (const std::size_t index : kind->held) kept.push_back(side[index]);
      const double sign = side == z ? 1 : kind->sign;
      kind->coarse->prolong(team_, sign * (kind == kinds_[0] ? symmetric : antisymmetric), side, sleepersAndAxle);
      for (std::size_t i = 0; i < kept.size(); ++i) side[kind->held[i]] = kept[i];
    }
}

}  // namespace squat::statics
