#include "elasticity/StandingWave.h"

#include <cmath>

#include "core/ElementaryFunctions.h"

namespace squat::elasticity {

IntervalMatrices intervalMatrices(const SweptBlock& block, int run) {
  const Eigen::Index size = 3 * block.nodes;
  IntervalMatrices interval{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size)};
  for (int i = 0; i < block.nodes; ++i)
    for (int p = block.rowStart[i]; p < block.rowStart[i + 1]; ++p) {
      const double* k = block.coefficients[run].data() + 18 * static_cast<std::size_t>(p);
      const int j = block.columns[p];
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
          interval.s(3 * i + row, 3 * j + column) += k[3 * row + column];
          interval.t(3 * i + row, 3 * j + column) += k[9 + 3 * row + column];
        }
    }
  return interval;
}

Eigen::MatrixXd standingWaveStiffness(const IntervalMatrices& interval, double half) {
  const double c = elementary::cos(half), s = elementary::sin(half);
  const Eigen::Vector3d forS(2 * s, 2 * c, 2 * c), forT(2 * c, -2 * s, -2 * s);
  const Eigen::Index nodes = interval.s.rows() / 3;
  const Eigen::VectorXd left = forS.replicate(nodes, 1), right = forT.replicate(nodes, 1);
  return left.asDiagonal() * interval.s * left.asDiagonal() +
         Eigen::MatrixXd(right.asDiagonal() * interval.t * right.asDiagonal());
}

}  // namespace squat::elasticity
