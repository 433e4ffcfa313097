// solver/statics/CoarseSpace.h - smooth displacement fields that carry what single-node preconditioning cannot.
//
// Rail: hats every 0.1 m along the track times the six rigid motions of a section and the softest shapes in its own
// plane: correcting node by node hardly ever bends the web. Sleepers: hats along the length times six rigid
// motions. Wheelset: hats along the axle times six rigid motions, hats around the rim times three translations and
// three rotations. Sprung mass: itself. Fields are products, so projecting a force and adding a field cost little more
// than reading it: forces are first summed to resultants of stations (or of section nodes around the axle), then to
// coarse unknowns.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <functional>
#include <span>
#include <vector>

#include "core/Monitor.h"
#include "model/StaticOperator.h"
#include "statics/SectionShapes.h"

namespace squat::statics {

class CoarseSpace {
 public:
  CoarseSpace(const model::Model& model, const model::StaticOperator& op);

  int size() const { return unknowns_; }
  // Z^T K Z without contact springs; call once. False when the monitor has cancelled it.
  bool assemble(model::StaticOperator& op, Monitor& monitor);
  // The same of any K that couples what that of the model couples: writes K u into the result (u, result).
  using Product = std::function<void(double*, double*)>;
  // `known`: another space of the same hats that is assembled already, and for which products, in their order, its
  // columns are those of this one. Those products are not computed.
  struct Known {
    const CoarseSpace& space;
    const std::vector<bool>& isSame;
  };
  bool assemble(ThreadTeam& team, const Product& product, Monitor& monitor, const Known* known = nullptr);
  const Eigen::MatrixXd& stiffness() const { return matrix_; }
  // Adds the share of contact springs and factorises.
  void factorise(std::span<const forces::ForceElements* const> contacts);
  void factorise(const forces::ForceElements& contact);
  // The correction Z y, y = (Z^T K Z)^-1 Z^T r, and what it has in common with the residual, r.Z y.
  struct Correction {
    Eigen::VectorXd y;
    double product = 0;
  };
  Correction correctionOf(ThreadTeam& team, const double* r) const;
  // The same by Z^T r, for who has it.
  Correction correctionOf(const Eigen::VectorXd& resultants) const;
  Eigen::VectorXd resultantsOf(ThreadTeam& team, const double* r) const;
  // z += Z y, zero where unknowns are fixed. Of some bodies alone: rail and rim, or all that reaches the track centre,
  // of which what is fixed is left to the caller.
  enum class Bodies { all, railAndRim, sleepersAndAxle };
  void prolong(ThreadTeam& team, const Eigen::VectorXd& y, double* z, Bodies bodies = Bodies::all) const;

 private:
  // Hats along a line-swept block; local axes (a, b, c), rotations about the knot at the section's middle.
  struct LineGroup {
    int block = 0, first = 0, modes = 6;  // first: coarse unknown of knot 0, mode 0
    std::vector<double> knots;
    double middleB = 0, middleC = 0;
    std::vector<SectionShape> shapes;  // modes after the sixth
  };
  // Unknowns of one colour do not reach each other: their columns of the matrix come from one product.
  enum class Part { track, rim, restOfWheelset };
  struct Placed {
    Part part = Part::track;
    int colour = 0;
    double place = 0;  // track: x [m]; rim: knot
  };
  Eigen::VectorXd projectSparse(const forces::ForceElements& springs, std::size_t spring) const;

  void addLineGroup(int block, double spacing, int shapes, int firstColour, int distance);
  void placeWheelset();
  // The unknown of a colour whose field reaches unknown i, or none (-1).
  int sourceFor(int i, const std::vector<int>& ofOneColour) const;
  void projectLine(const LineGroup& group, const double* r, int part, int parts, double* coarse) const;
  void prolongLine(const LineGroup& group, const double* coarse, int part, int parts, double* z) const;
  void projectWheel(int block, const double* r, double* coarse) const;
  void prolongWheel(int block, const double* coarse, int part, int parts, double* z) const;
  double axleHat(int block, int node, int knot) const;

  const model::Model& model_;
  const std::vector<unsigned char>& free_;
  std::vector<LineGroup> lines_;
  std::vector<Placed> placed_;
  std::vector<double> axleKnots_;
  double rimMiddle_ = 0;  // [m] radius
  int axleFirst_ = 0, rimFirst_ = 0, sprungFirst_ = 0, unknowns_ = 0;
  std::vector<std::size_t> sprung_, fixedOnRailAndRim_;
  std::vector<std::vector<double>> cosine_, sine_;  // per block around the axis: of the stations as placed
  std::vector<std::vector<double>> rimShare_;       // per block: of each section node in the rim's hats
  Eigen::MatrixXd matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;  // the rail's part is banded
};

}  // namespace squat::statics
