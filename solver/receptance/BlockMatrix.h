// solver/receptance/BlockMatrix.h - symmetric matrices of dense blocks, and complex symmetric systems of them.
#pragma once

#include <Eigen/LU>
#include <complex>
#include <map>
#include <vector>

namespace squat::receptance {

// Groups of unknowns: sizes and the first unknown of each; `first` has one entry more.
struct Groups {
  std::vector<int> size;
  std::vector<Eigen::Index> first{0};
  int add(int count);
  int count() const { return static_cast<int>(size.size()); }
  Eigen::Index unknowns() const { return first.back(); }
};

// Blocks (i, j) with i <= j; the rest by symmetry.
class BlockMatrix {
 public:
  explicit BlockMatrix(const Groups& groups) : groups_(&groups), rows_(groups.size.size()) {}

  // The block of groups i <= j, made when it is not there.
  Eigen::MatrixXd& block(int i, int j);
  const std::map<int, Eigen::MatrixXd>& row(int i) const { return rows_[i]; }
  const Groups& groups() const { return *groups_; }

  // Adds `factor` times the outer product of a vector that is given by its pieces in a few groups, ascending.
  void addOuter(const std::map<int, Eigen::VectorXd>& pieces, double factor);

  // this * vectors, one a column.
  Eigen::MatrixXd times(const Eigen::MatrixXd& vectors) const;
  Eigen::MatrixXcd times(const Eigen::MatrixXcd& vectors) const;

 private:
  const Groups* groups_;
  std::vector<std::map<int, Eigen::MatrixXd>> rows_;
};

// Factors of a complex symmetric matrix of blocks, groups in the order of their elimination.
class BlockFactor {
 public:
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const;

 private:
  friend class DynamicStiffness;
  const Groups* groups_ = nullptr;
  std::vector<int> order_;
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> pivot_;
  std::vector<std::vector<int>> later_;   // groups (places in the order) that each is coupled with
  std::vector<Eigen::MatrixXcd> solved_;  // pivot^-1 times the couplings with these, side by side
};

// K + i w C - w^2 M: eliminated by whole groups, the one with fewest unknowns about it first. Pivots are sought within
// a group only; residual() says whether that was good enough.
class DynamicStiffness {
 public:
  // All three have the same groups.
  DynamicStiffness(const BlockMatrix& stiffness, const BlockMatrix& damping, const BlockMatrix& mass);

  // At the angular frequency [rad/s]. Safe to call from several threads.
  BlockFactor factor(double omega) const;

  // Coefficients x_0 ... x_order of the Taylor series of the solution for one right side about the frequency of a
  // factor: A x_k = -(i C - 2 w M) x_(k-1) + M x_(k-2), scaled by `reach` [rad/s] to the power k.
  std::vector<Eigen::MatrixXcd> taylor(const BlockFactor& factor, double omega, const Eigen::MatrixXd& load, int order,
                                       double reach) const;

  // Largest of |A x - b| over |b| of the columns.
  double residual(double omega, const Eigen::MatrixXcd& x, const Eigen::MatrixXd& load) const;

 private:
  const BlockMatrix &stiffness_, &damping_, &mass_;
  std::vector<int> order_, placeInOrder_;
};

}  // namespace squat::receptance
