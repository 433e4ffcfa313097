#include "statics/StaticSystem.h"

namespace squat::statics {

double StaticSystem::rollingRadius() const {
  double sum = 0;
  for (const auto& half : halves_) sum += half.model.surfaces.radius;
  return sum / static_cast<double>(halves_.size());
}

HalfSystem::HalfSystem(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                       double rotation)
    : StaticSystem(team, rotation), kernels_(kernels) {
  halves_.push_back(
      {model, std::make_unique<model::StaticOperator>(model, kernels, team, rotation, rotationStiffness, true), 0});
}

std::unique_ptr<StaticSystem> HalfSystem::turnedBy(double rotation) const {
  return std::make_unique<HalfSystem>(halves_.front().model, kernels_, team_, rotation_ + rotation);
}

bool HalfSystem::assemble(Monitor& monitor) {
  coarse_.emplace(halves_.front().model, op());
  return coarse_->assemble(op(), monitor);
}

void HalfSystem::factorise() { coarse_->factorise(op().contactSprings()); }

AlignedVector HalfSystem::inverseDiagonal() const {
  const auto& op = *halves_.front().op;
  AlignedVector inverse = op.diagonal();
  const auto& free = op.freeUnknowns();
  for (std::size_t i = 0; i < inverse.size(); ++i) inverse[i] = free[i] ? 1 / inverse[i] : 0;
  return inverse;
}

}  // namespace squat::statics
