#include "estimation/LeastSquares.h"

#include <algorithm>
#include <cmath>

#include "core/DenseAlgebra.h"

namespace squat::estimation {

LinearSolution solve(const LinearProblem& problem, double scale, double noise, double damping) {
  const auto& slope = problem.slope;
  const auto& penalty = problem.penalty;
  const double data = 1 / (noise * noise), prior = 1 / (scale * scale);
  const Eigen::MatrixXd fromData = data * slope.transpose() * slope;
  Eigen::MatrixXd normal = fromData + prior * penalty.transpose() * penalty;
  Eigen::VectorXd downhill =
      -(data * slope.transpose() * problem.residuals + prior * penalty.transpose() * (penalty * problem.unknowns));
  if (problem.limits.rows() > 0) {
    normal += problem.limits.transpose() * problem.limits;
    downhill -= problem.limits.transpose() * problem.excess;
  }
  LinearSolution solution;
  solution.covariance =
      algebra::solveSymmetric(normal, Eigen::MatrixXd(Eigen::MatrixXd::Identity(normal.rows(), normal.cols())));
  solution.freedom = (solution.covariance * fromData).trace();
  Eigen::MatrixXd damped = normal;
  damped.diagonal() *= 1 + damping;
  const Eigen::VectorXd step = algebra::solveSymmetric(damped, downhill);
  solution.unknowns = problem.unknowns + step;
  solution.misfit = (problem.residuals + slope * step).squaredNorm();
  return solution;
}

Regularisation chooseScale(const LinearProblem& problem, double smallest, double largest) {
  constexpr int steps = 40;
  const auto number = static_cast<double>(problem.residuals.size());
  const auto left = [&](const LinearSolution& solution) { return std::max(1.0, number - solution.freedom); };
  Regularisation chosen{largest, 1};
  // The noise and the freedom hang on each other: a few rounds settle both.
  for (int round = 0; round < 5; ++round) {
    const auto loosest = solve(problem, largest, chosen.noise);
    chosen.noise = std::max(1.0, std::sqrt(loosest.misfit / left(loosest)));
  }
  constexpr double slack = 1.02;  // of the misfit: the last two per cent cost more roughness than they tell
  for (int i = 0; i <= steps; ++i) {
    const double scale = smallest * std::pow(largest / smallest, static_cast<double>(i) / steps);
    const auto solution = solve(problem, scale, chosen.noise);
    chosen.scale = scale;
    if (solution.misfit <= slack * chosen.noise * chosen.noise * left(solution)) break;
  }
  return chosen;
}

void update(Eigen::MatrixXd& slope, const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
  const double length = step.squaredNorm();
  if (length > 0) slope += (change - slope * step) * step.transpose() / length;
}

}  // namespace squat::estimation
