#include "estimation/SmoothProfile.h"

#include <algorithm>
#include <cmath>

#include "core/DenseAlgebra.h"

namespace squat::estimation {

SmoothProfile::SmoothProfile(double first, double last, double spacing) {
  const long parts = std::max(4L, std::lround((last - first) / spacing));
  for (long i = 0; i <= parts; ++i)
    knots_.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(parts));
  const long steps = std::max(parts, std::lround((last - first) / sampleStep));
  for (long i = 0; i <= steps; ++i)
    positions_.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(steps));
  makeSpline();
}

// Second derivatives M at the knots follow from the heights y: at an inner knot M[i-1] + 4 M[i] + M[i+1] = 6 / h^2
// (y[i-1] - 2 y[i] + y[i+1]), at the ends 2 M[0] + M[1] = 6 / h^2 (y[1] - y[0]) and its mirror for zero slope.
void SmoothProfile::makeSpline() {
  const auto n = static_cast<Eigen::Index>(knots_.size());
  const double h = knots_[1] - knots_[0];
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n, n), right = left;
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool isEnd = i == 0 || i + 1 == n;
    left(i, i) = isEnd ? 2 : 4;
    right(i, i) = isEnd ? -1 : -2;
    if (i > 0) left(i, i - 1) = right(i, i - 1) = 1;
    if (i + 1 < n) left(i, i + 1) = right(i, i + 1) = 1;
  }
  const Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(n, n).middleCols(1, n - 2);
  curvature_ = algebra::solveSquare(left, 6 / (h * h) * right * inner);
  const auto samples = static_cast<Eigen::Index>(positions_.size());
  basis_.resize(samples, n - 2);
  for (Eigen::Index s = 0; s < samples; ++s) {
    const double place = (positions_[static_cast<std::size_t>(s)] - knots_.front()) / h;
    const auto i = std::clamp(static_cast<Eigen::Index>(place), Eigen::Index{0}, n - 2);
    const double u = place - static_cast<double>(i), v = 1 - u;
    basis_.row(s) = v * inner.row(i) + u * inner.row(i + 1) + h * h / 6 * (v * v * v - v) * curvature_.row(i) +
                    h * h / 6 * (u * u * u - u) * curvature_.row(i + 1);
  }
}

ProfilePoints SmoothProfile::points(const Eigen::VectorXd& heights) const {
  const Eigen::VectorXd all = basis_ * heights;
  ProfilePoints list;
  for (std::size_t i = 0; i < positions_.size(); ++i)
    list.push_back({positions_[i], all[static_cast<Eigen::Index>(i)]});
  list.front().height = list.back().height = 0;
  return list;
}

Eigen::VectorXd SmoothProfile::fit(const std::function<double(double)>& height) const {
  Eigen::VectorXd wanted(basis_.rows());
  for (std::size_t i = 0; i < positions_.size(); ++i) wanted[static_cast<Eigen::Index>(i)] = height(positions_[i]);
  return algebra::solveLeastSquares(basis_, wanted);
}

}  // namespace squat::estimation
