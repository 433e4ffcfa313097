// solver/statics/WholeSystem.h - the linear system of both halves of a whole model (model/CentrePlane.h: shared).
//
// The unknowns are those of both halves, equal in size or opposite where the halves meet: K of the whole is P K_halves
// P, P the orthogonal projection on such motions, and conjugate gradients that start in its range stay there. The
// coarse space is that of symmetric motions and that of antisymmetric ones, left = s + a, right = s - a, each with the
// stiffness of both halves; what unlike sides couple between the two is left to the iterations.
//
// Springs between the halves: that of the mean rotation, and the lateral suspension, which both axle boxes feel by the
// lateral motion of the wheelset, half the difference of what they move outwards.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "model/CentrePlane.h"
#include "statics/StaticSystem.h"

namespace squat::statics {

class WholeSystem : public StaticSystem {
 public:
  // Throws std::invalid_argument where the models do not have like unknowns.
  WholeSystem(const model::Model& left, const model::Model& right, const elasticity::KernelSet& kernels,
              ThreadTeam& team, double rotation);

  std::unique_ptr<StaticSystem> turnedBy(double rotation) const override;
  bool assemble(Monitor& monitor) override;
  void factorise() override;
  void apply(double* u, double* result) override;
  AlignedVector inverseDiagonal() const override;
  CoarseSpace::Correction correctionOf(const double* r) const override;
  void prolong(const Eigen::VectorXd& y, double* z) const override;
  void join(double* state) const override;
  double energyBetween(const double* u) const override;

 private:
  // Motions of one symmetry.
  struct Kind {
    Kind(const model::Model& half, model::Centre centre);
    model::Model model;             // with the centre plane as these motions have it
    double sign = 1;                // of the right side's motion
    std::vector<std::size_t> held;  // unknowns that do not move
    std::optional<CoarseSpace> coarse;
  };
  void joinAs(const model::CentreNodes& centre, double* state) const;
  // K of all in terms of one side's motion of a kind; what is held is held in u, not yet in the result.
  void applyToKind(const Kind& kind, double* u, double* result);
  // Whether the kinds differ for this u, of which `result` is K u.
  bool reachesCentre(const double* u, const double* result) const;
  double* rightOf(double* state) const { return state + halves_.back().offset; }
  const double* rightOf(const double* state) const { return state + halves_.back().offset; }

  elasticity::KernelSet kernels_;
  std::vector<model::CentreNodes> centre_;      // where the halves meet
  forces::ForceElements between_;               // unknowns of both halves
  std::array<std::unique_ptr<Kind>, 2> kinds_;  // symmetric, antisymmetric
  AlignedVector both_, pushed_;                 // of applyToKind
  std::vector<std::size_t> coupled_;            // unknowns of one side that between_ reaches
};

}  // namespace squat::statics
