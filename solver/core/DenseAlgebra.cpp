#include "core/DenseAlgebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace squat::algebra {

VectorXd solveSymmetric(const MatrixXd& a, const VectorXd& b) { return a.ldlt().solve(b); }
MatrixXd solveSymmetric(const MatrixXd& a, const MatrixXd& b) { return a.ldlt().solve(b); }
MatrixXd solveSquare(const MatrixXd& a, const MatrixXd& b) { return a.partialPivLu().solve(b); }
VectorXd solveLeastSquares(const MatrixXd& a, const VectorXd& b) { return a.colPivHouseholderQr().solve(b); }

struct SymmetricFactor::Factor : Eigen::LDLT<MatrixXd> {
  using LDLT::LDLT;
};
SymmetricFactor::SymmetricFactor(const MatrixXd& a) : factor_(std::make_unique<Factor>(a)) {}
SymmetricFactor::~SymmetricFactor() = default;
VectorXd SymmetricFactor::solve(const VectorXd& b) const { return factor_->solve(b); }

struct PositiveFactor::Factor : Eigen::LLT<MatrixXd> {
  using LLT::LLT;
};
PositiveFactor::PositiveFactor(const MatrixXd& a) : factor_(std::make_unique<Factor>(a)) {}
PositiveFactor::~PositiveFactor() = default;
MatrixXd PositiveFactor::solve(const MatrixXd& b) const { return factor_->solve(b); }
MatrixXd PositiveFactor::lower() const { return factor_->matrixL(); }

EigenPairs symmetricEigenPairs(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(a);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

MatrixXd inverseSquareRoot(const MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a).operatorInverseSqrt();
}

double largestOfTridiagonal(const VectorXd& diagonal, const VectorXd& side) {
  Eigen::SelfAdjointEigenSolver<MatrixXd> eigen;
  eigen.computeFromTridiagonal(diagonal, side, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().maxCoeff();
}

MatrixXd orthonormalColumns(const MatrixXd& a) {
  const Eigen::HouseholderQR<MatrixXd> qr(a);
  return qr.householderQ() * MatrixXd::Identity(a.rows(), a.cols());
}

MatrixXd orthonormalSpan(const MatrixXd& a, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(a);
  qr.setThreshold(threshold);
  MatrixXd span = MatrixXd::Zero(a.rows(), a.cols());
  span.leftCols(qr.rank()) = MatrixXd(qr.householderQ()).leftCols(qr.rank());
  return span;
}

}  // namespace squat::algebra
