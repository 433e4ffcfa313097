// solver/calibration/Knowledge.h - what a search knows of its inputs, and what not.
//
// A point is as good as the best one where it meets every statement that this one meets, misses no other one by more
// than a tenth beyond what this one does, and where its data misfit
// (sum of squared residuals) is larger by no more than noise explains: by max(1, chi2 / (N - n)) times the 95 %
// quantile of chi-square with n degrees of freedom, N independent samples and n inputs (W. H. Press et al., Numerical
// Recipes, section 15.6: confidence limits on estimated parameters).
#pragma once

#include <vector>

#include "calibration/Calibration.h"
#include "calibration/Derivatives.h"

namespace squat::calibration {

class EquallyGood {
 public:
  EquallyGood(const Targets& targets, const Evaluation& best, std::size_t inputs);
  bool operator()(const Evaluation& evaluation) const;
  // By the linear model; `way` from its centre.
  bool operator()(const LinearModel& model, const Eigen::VectorXd& way) const;
  bool hasData() const { return samples_ > 0; }

 private:
  bool accepts(const std::vector<double>& away, double squares) const;

  std::size_t statements_ = 0, samples_ = 0;
  std::vector<double> largest_;  // residual of each statement
  double largestSquares_ = 0;
};

// Points of the cube that the linear model calls equally good, by a random walk from its centre (fixed seed).
std::vector<UnitPoint> equallyGoodByModel(const EquallyGood& isEquallyGood, const LinearModel& model,
                                          std::size_t count);

// Some of the points, as far from each other as they can be.
std::vector<UnitPoint> spreadOut(const std::vector<UnitPoint>& points, std::size_t count);

// The 95 % quantile of chi-square, by Wilson and Hilferty's formula (1931): within 1 % from two degrees of freedom on.
double chiSquareQuantile95(std::size_t degrees);

// Fills ranges, correlation, equallyGood and outOfReach of a calibration whose evaluations and bests are known.
void summarise(Calibration& calibration, const EquallyGood& isEquallyGood, const LinearModel& model,
               const std::vector<UnitPoint>& byModel);

}  // namespace squat::calibration
