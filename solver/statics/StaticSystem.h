// solver/statics/StaticSystem.h - the linear system of the equilibrium: stiffness and preconditioner of one half of the
// model, or of both (WholeSystem.h).
//
// Vectors hold the states of the halves, each at its offset. All at one rotation of the wheelset; the sprung mass is
// fixed along the track, the wheelset's mean rotation by a spring.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "core/Monitor.h"
#include "model/StaticOperator.h"
#include "statics/CoarseSpace.h"

namespace squat::statics {

// [N m/rad] Any stiffness fixes the rotation; this one is of the order of the contact's.
inline constexpr double rotationStiffness = 1e8;

struct StaticHalf {
  const model::Model& model;
  std::unique_ptr<model::StaticOperator> op;  // with the springs of the closed contact
  std::size_t offset = 0;
};

class StaticSystem {
 public:
  virtual ~StaticSystem() = default;
  const std::vector<StaticHalf>& halves() const { return halves_; }
  std::size_t size() const { return halves_.back().offset + halves_.back().model.stateSize; }
  double rotation() const { return rotation_; }
  ThreadTeam& team() const { return team_; }
  double rollingRadius() const;  // [m] mean of all wheels

  // The same at another rotation, not assembled.
  virtual std::unique_ptr<StaticSystem> turnedBy(double rotation) const = 0;
  // The coarse stiffness without contact springs; false when the monitor has cancelled it.
  virtual bool assemble(Monitor& monitor) = 0;
  // With the contact springs of all halves.
  virtual void factorise() = 0;
  virtual void apply(double* u, double* result) = 0;
  // Zero where the unknown is not free.
  virtual AlignedVector inverseDiagonal() const = 0;
  virtual CoarseSpace::Correction correctionOf(const double* r) const = 0;
  virtual void prolong(const Eigen::VectorXd& y, double* z) const = 0;
  // Makes forces or motions those of one body where halves meet.
  virtual void join(double* state) const = 0;
  // [J] stored in what joins halves besides their solids.
  virtual double energyBetween(const double* u) const = 0;

 protected:
  StaticSystem(ThreadTeam& team, double rotation) : team_(team), rotation_(rotation) {}
  ThreadTeam& team_;
  double rotation_;
  std::vector<StaticHalf> halves_;
};

// A half model, or both halves as mirror images.
class HalfSystem : public StaticSystem {
 public:
  HalfSystem(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double rotation);

  std::unique_ptr<StaticSystem> turnedBy(double rotation) const override;
  bool assemble(Monitor& monitor) override;
  void factorise() override;
  void apply(double* u, double* result) override { op().apply(u, result); }
  AlignedVector inverseDiagonal() const override;
  CoarseSpace::Correction correctionOf(const double* r) const override { return coarse_->correctionOf(team_, r); }
  void prolong(const Eigen::VectorXd& y, double* z) const override { coarse_->prolong(team_, y, z); }
  void join(double*) const override {}
  double energyBetween(const double*) const override { return 0; }

  model::StaticOperator& op() { return *halves_.front().op; }

 private:
  elasticity::KernelSet kernels_;
  std::optional<CoarseSpace> coarse_;
};

}  // namespace squat::statics
