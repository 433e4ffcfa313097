// solver/estimation/LeastSquares.h - the linear algebra of regularised least squares.
//
// Unknowns p explain data: residuals r + J (q - p) over their noise, beside a penalty |C q / scale|^2, which stands for
// knowing beforehand that each row of C q is normal with deviation `scale`. Both together are a normal distribution of
// the unknowns; its mean is the step of Gauss and Newton, its covariance gives the bounds.
#pragma once

#include <Eigen/Core>

namespace squat::estimation {

struct LinearProblem {
  Eigen::VectorXd residuals;  // over the noise, at `unknowns`
  Eigen::MatrixXd slope;      // J
  Eigen::MatrixXd penalty;    // C
  Eigen::VectorXd unknowns;   // p
  // Other knowledge, rows over their deviation and its value at `unknowns`; may be empty.
  Eigen::MatrixXd limits = {};
  Eigen::VectorXd excess = {};
};

struct LinearSolution {
  Eigen::VectorXd unknowns;
  Eigen::MatrixXd covariance;
  double misfit = 0;   // sum of squares of the predicted residuals
  double freedom = 0;  // effective number of unknowns: trace of the data's influence on their own prediction
};

// `noise`: factor on the noise, 1: as estimated. `damping` holds the step back as Levenberg's does, relative to the
// curvature of each unknown; the covariance is that without it.
LinearSolution solve(const LinearProblem& problem, double scale, double noise = 1, double damping = 0);

struct Regularisation {
  double scale = 0;
  double noise = 1;  // factor on the noise that the residuals ask for
};

// The discrepancy principle, corrected for the unknowns that the data are fitted with: the smallest scale between the
// limits at which the residuals are as small as their noise lets them be, misfit = noise^2 (number - freedom). Where
// not even the largest scale brings them there, the noise is taken to be larger by what remains.
Regularisation chooseScale(const LinearProblem& problem, double smallest, double largest);

// Broyden's update of the slope: J step then gives the change of residuals that was seen.
void update(Eigen::MatrixXd& slope, const Eigen::VectorXd& step, const Eigen::VectorXd& change);

}  // namespace squat::estimation
