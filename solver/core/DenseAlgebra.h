// solver/core/DenseAlgebra.h - decompositions of dense matrices, by Eigen. They stand here because their templates cost
// seconds of compilation in every source that asks for them; sources elsewhere keep to sums and products.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace squat::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Solves a x = b for a symmetric a, definite or semidefinite (L D L^T, pivoted).
VectorXd solveSymmetric(const MatrixXd& a, const VectorXd& b);
MatrixXd solveSymmetric(const MatrixXd& a, const MatrixXd& b);

// Solves a x = b for any regular a (L U, partially pivoted).
MatrixXd solveSquare(const MatrixXd& a, const MatrixXd& b);

// The x of least squares |a x - b| (Householder, pivoted).
VectorXd solveLeastSquares(const MatrixXd& a, const VectorXd& b);

// Factors of a symmetric matrix for many right-hand sides.
class SymmetricFactor {
 public:
  explicit SymmetricFactor(const MatrixXd& a);
  ~SymmetricFactor();
  VectorXd solve(const VectorXd& b) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

// Cholesky's factors of a positive definite matrix for many right-hand sides, side by side.
class PositiveFactor {
 public:
  explicit PositiveFactor(const MatrixXd& a);
  ~PositiveFactor();
  MatrixXd solve(const MatrixXd& b) const;
  MatrixXd lower() const;  // L of a = L L^T

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

struct EigenPairs {
  VectorXd values;   // ascending
  MatrixXd vectors;  // columns, orthonormal
};

EigenPairs symmetricEigenPairs(const MatrixXd& a);

// a^-1/2 of a positive definite matrix, symmetric itself.
MatrixXd inverseSquareRoot(const MatrixXd& a);

// Largest eigenvalue of the symmetric tridiagonal matrix; `side` has one number less than `diagonal`.
double largestOfTridiagonal(const VectorXd& diagonal, const VectorXd& side);

// As many orthonormal columns as `a` has, which is to have full rank (Householder).
MatrixXd orthonormalColumns(const MatrixXd& a);

// Orthonormal columns that span those of `a` as far as its pivots exceed `threshold` times the largest; the columns
// that are left are zero.
MatrixXd orthonormalSpan(const MatrixXd& a, double threshold);

}  // namespace squat::algebra
