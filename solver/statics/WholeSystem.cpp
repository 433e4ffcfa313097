#include "statics/WholeSystem.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/OrderedSum.h"

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
  // Both halves of a half model's spring.
  between_.add(meanOf(model::hubTurn(left), offset, 1), 2 * rotationStiffness, 0);
  // Both suspensions along the wheelset's lateral motion.
  between_.add(meanOf(model::ringLateral(left, left.bearing), offset, -1),
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
  for (const std::size_t index : kind.held) result[index] = 0;
}

std::unique_ptr<WholeSystem::Kind> WholeSystem::assembled(model::Centre centre, Monitor& monitor) {
  auto kind = std::make_unique<Kind>(halves_[0].model, centre);
  kind->coarse.emplace(kind->model, *halves_[0].op);
  const bool isDone = kind->coarse->assemble(
      team_, [&](double* u, double* result) { applyToKind(*kind, u, result); }, monitor);
  return isDone ? std::move(kind) : nullptr;
}

bool WholeSystem::assemble(Monitor& monitor) {
  std::array<forces::ForceElements, 2> kept;
  for (std::size_t i = 0; i < 2; ++i) kept[i] = std::exchange(halves_[i].op->contactSprings(), {});
  both_.assign(size(), 0.0), pushed_.assign(size(), 0.0);
  for (auto& field : field_) field.assign(halves_[0].model.stateSize, 0.0);
  kinds_[0] = assembled(model::Centre::symmetric, monitor);
  kinds_[1] = kinds_[0] ? assembled(model::Centre::antisymmetric, monitor) : nullptr;
  for (std::size_t i = 0; i < 2; ++i) halves_[i].op->contactSprings() = std::move(kept[i]);
  both_ = {}, pushed_ = {};
  return kinds_[1] != nullptr;
}

void WholeSystem::factorise() {
  const std::array<const forces::ForceElements*, 2> contacts{&halves_[0].op->contactSprings(),
                                                             &halves_[1].op->contactSprings()};
  for (auto& kind : kinds_) kind->coarse->factorise(contacts);
}

template <typename Work>
void WholeSystem::forEachInBoth(const Work& work) const {
  orderedSum(team_, halves_[0].model.stateSize, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
    return 0.0;
  });
}

CoarseSpace::Correction WholeSystem::correctionOf(const double* r) const {
  auto &s = field_[0], &a = field_[1];
  const double* right = rightOf(r);
  forEachInBoth([&](std::size_t i) { s[i] = r[i] + right[i], a[i] = r[i] - right[i]; });
  const auto symmetric = kinds_[0]->coarse->correctionOf(team_, s.data());
  const auto antisymmetric = kinds_[1]->coarse->correctionOf(team_, a.data());
  CoarseSpace::Correction both{Eigen::VectorXd(symmetric.y.size() + antisymmetric.y.size()),
                               symmetric.product + antisymmetric.product};
  both.y << symmetric.y, antisymmetric.y;
  return both;
}

void WholeSystem::prolong(const Eigen::VectorXd& y, double* z) const {
  for (std::size_t k = 0; k < 2; ++k) {
    auto& field = field_[k];
    forEachInBoth([&](std::size_t i) { field[i] = 0; });
    const auto& coarse = *kinds_[k]->coarse;
    coarse.prolong(team_, k == 0 ? y.head(coarse.size()) : y.tail(coarse.size()), field.data());
    for (const std::size_t index : kinds_[k]->held) field[index] = 0;
  }
  const auto &s = field_[0], &a = field_[1];
  double* right = rightOf(z);
  forEachInBoth([&](std::size_t i) { z[i] += s[i] + a[i], right[i] += s[i] - a[i]; });
}

}  // namespace squat::statics
