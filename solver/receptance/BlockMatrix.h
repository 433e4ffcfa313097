// solver/receptance/BlockMatrix.h - symmetric matrices of dense blocks, and complex symmetric systems of them.
#pragma once

#include <Eigen/LU>
#include <complex>
#include <functional>
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

// One summand of a dynamic stiffness: a real matrix times a number that depends on the angular frequency [rad/s]:
// 1 of a stiffness, 1 + i eta with a loss factor, i w of dashpots, -w^2 of the mass.
struct HarmonicTerm {
  const BlockMatrix* matrix = nullptr;
  std::function<std::complex<double>(double)> factor;
};

// What is left of a system once all groups but a few are eliminated: D u = F of the kept groups, in the order in which
// they were named. A response r of the whole system to load l is then r_kept^T u + between(r, l).
struct CondensedSystem {
  Eigen::MatrixXcd stiffness;  // of the kept unknowns
  Eigen::MatrixXcd loads;      // kept unknowns x loads
  Eigen::MatrixXcd between;    // loads x loads: what the eliminated unknowns answer with the kept ones at rest
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
  Eigen::MatrixXcd kept_;                 // dense, of the groups that are not eliminated
};

// The sum of terms: eliminated by whole groups, the one with fewest unknowns about it first. Pivots are sought within a
// group only; residual() says whether that was good enough.
class DynamicStiffness {
 public:
  // All terms have the same groups. `kept` groups are not eliminated: the system can be condensed to them.
  explicit DynamicStiffness(std::vector<HarmonicTerm> terms, std::vector<int> kept = {});

  // At the angular frequency [rad/s]. Safe to call from several threads. Nothing may be kept.
  BlockFactor factor(double omega) const { return eliminate(omega); }

  // The system as the kept groups see it, and loads, one a column, passed on to them.
  CondensedSystem condense(double omega, const Eigen::MatrixXd& loads) const;

  // Coefficients x_0 ... x_order of the Taylor series of the solution about the frequency of a factor, scaled by
  // `reach` [rad/s] to the power k: A x_k = -A' x_(k-1) - A''/2 x_(k-2); higher derivatives of the factors are left
  // out (there are none without tabulated stiffness).
  std::vector<Eigen::MatrixXcd> taylor(const BlockFactor& factor, double omega, const Eigen::MatrixXd& load, int order,
                                       double reach) const;

  // Largest of |A x - b| over |b| of the columns.
  double residual(double omega, const Eigen::MatrixXcd& x, const Eigen::MatrixXd& load) const;

 private:
  BlockFactor eliminate(double omega) const;
  Eigen::MatrixXcd keptOf(const std::vector<Eigen::MatrixXcd>& pivot,
                          const std::vector<std::map<int, Eigen::MatrixXcd>>& rows) const;

  std::vector<HarmonicTerm> terms_;
  const Groups& groups_;
  int eliminated_ = 0;  // groups
  std::vector<int> order_, placeInOrder_;
};

}  // namespace squat::receptance
