// Regularised least squares against closed forms.
#include "estimation/LeastSquares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace squat::estimation {
namespace {

// n data of one unknown x, each x + noise of deviation 1, beside the knowledge that x is normal with deviation s: the
// posterior of the mean has variance 1 / (n + 1 / s^2) and lies at n / (n + 1 / s^2) times the mean of the data.
TEST(LeastSquares, OneUnknownIsTheTextbookPosterior) {
  constexpr int n = 4;
  constexpr double s = 0.5, mean = 3;
  LinearProblem problem;
  problem.unknowns = Eigen::VectorXd::Zero(1);
  problem.slope = Eigen::MatrixXd::Ones(n, 1);
  problem.residuals = Eigen::VectorXd::Constant(n, -mean);
  problem.penalty = Eigen::MatrixXd::Ones(1, 1);
  const auto solution = solve(problem, s);
  const double weight = n + 1 / (s * s);
  EXPECT_NEAR(solution.unknowns[0], n * mean / weight, 1e-12);  // rounding
  EXPECT_NEAR(solution.covariance(0, 0), 1 / weight, 1e-12);
  EXPECT_NEAR(solution.freedom, n / weight, 1e-12);
  EXPECT_NEAR(solution.misfit, n * std::pow(mean - n * mean / weight, 2), 1e-12);
  // Twice the noise: a quarter of the weight of the data.
  EXPECT_NEAR(solve(problem, s, 2).covariance(0, 0), 1 / (n / 4.0 + 1 / (s * s)), 1e-12);
}

// Where the search stands already must not matter: the penalty is on the unknown itself, not on the step.
TEST(LeastSquares, TheSolutionDoesNotDependOnWhereItStarts) {
  LinearProblem problem;
  problem.slope = Eigen::MatrixXd{{1, 2}, {0, 1}, {3, 1}};
  problem.penalty = Eigen::MatrixXd{{1, -1}};
  problem.unknowns = Eigen::VectorXd::Zero(2);
  problem.residuals = Eigen::Vector3d(-1, 0.5, -2);
  const auto fromZero = solve(problem, 0.7);
  auto moved = problem;
  moved.unknowns = Eigen::Vector2d(4, -3);
  moved.residuals += problem.slope * moved.unknowns;
  EXPECT_NEAR((solve(moved, 0.7).unknowns - fromZero.unknowns).norm(), 0, 1e-12);  // rounding
  EXPECT_LT((solve(problem, 0.7, 1, 10).unknowns).norm(), fromZero.unknowns.norm());
}

// Data of a smooth curve with noise of deviation 1. The scale that is chosen leaves residuals as large as the noise
// over what is not fitted, by its own definition; that it recovers the curve better than either limit is the point of
// it.
TEST(LeastSquares, TheScaleLeavesTheNoiseAndNothingElse) {
  constexpr int n = 60;
  LinearProblem problem;
  problem.slope = Eigen::MatrixXd::Identity(n, n);
  problem.unknowns = Eigen::VectorXd::Zero(n);
  problem.penalty = Eigen::MatrixXd::Zero(n - 2, n);
  for (int i = 0; i + 2 < n; ++i) problem.penalty.row(i).segment(i, 3) << 1, -2, 1;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Eigen::VectorXd truth(n);
  problem.residuals.resize(n);
  for (int i = 0; i < n; ++i) {
    truth[i] = 8 * std::sin(0.15 * i);
    problem.residuals[i] = -(truth[i] + normal(random));
  }
  const auto chosen = chooseScale(problem, 1e-3, 1e3);
  const auto solution = solve(problem, chosen.scale, chosen.noise);
  EXPECT_EQ(chosen.noise, 1);  // it is what it was said to be
  EXPECT_LE(solution.misfit, 1.02 * (n - solution.freedom));
  const auto error = [&](double scale) { return (solve(problem, scale).unknowns - truth).norm(); };
  EXPECT_LT(error(chosen.scale), 0.5 * error(1e3));
  EXPECT_LT(error(chosen.scale), 0.5 * error(1e-3));
}

// What no unknown can explain counts as noise: half the data are off by 10 where two equal rows cannot agree.
TEST(LeastSquares, WhatCannotBeExplainedCountsAsNoise) {
  constexpr int pairs = 50;
  LinearProblem problem;
  problem.unknowns = Eigen::VectorXd::Zero(1);
  problem.slope = Eigen::MatrixXd::Ones(2 * pairs, 1);
  problem.penalty = Eigen::MatrixXd::Ones(1, 1);
  problem.residuals.resize(2 * pairs);
  for (int i = 0; i < 2 * pairs; ++i) problem.residuals[i] = i % 2 == 0 ? 10 : -10;
  const auto chosen = chooseScale(problem, 0.1, 10);
  // Sum of squares 100 n over n - freedom, and one unknown takes at most one.
  EXPECT_NEAR(chosen.noise, 10, 0.06);
}

TEST(LeastSquares, BroydensUpdateGivesTheChangeThatWasSeen) {
  Eigen::MatrixXd slope{{1, 2}, {3, 4}};
  const Eigen::Vector2d step(1, 1), across(1, -1), change(5, 6);
  const Eigen::Vector2d before = slope * across;
  update(slope, step, change);
  EXPECT_NEAR((slope * step - change).norm(), 0, 1e-12);
  EXPECT_NEAR((slope * across - before).norm(), 0, 1e-12);  // nothing was learnt across the step
}

}  // namespace
}  // namespace squat::estimation
