// solver/estimation/SmoothProfile.h - the profile that is looked for: heights at equally spaced knots and the smooth
// curve through them, level and at rest at both ends.
//
// A cubic spline with zero height and zero slope at its two outermost knots; the heights of all others are the
// unknowns. It is linear in them, so that bounds of heights become bounds of the profile. A run gets samples of it
// every millimetre, between which it draws the curve of scenario/ProfileCurve.h.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "scenario/Defect.h"

namespace squat::estimation {

using ProfilePoints = std::vector<scenario::ProfilePoint>;

class SmoothProfile {
 public:
  static constexpr double sampleStep = 1e-3;  // [m]

  // Knots from `first` to `last` [m], about `spacing` apart, at least five.
  SmoothProfile(double first, double last, double spacing);

  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(knots_.size()) - 2; }
  const std::vector<double>& knots() const { return knots_; }          // [m] the outermost two included
  const std::vector<double>& positions() const { return positions_; }  // [m] of the samples
  const Eigen::MatrixXd& basis() const { return basis_; }              // heights of samples from those of knots
  const Eigen::MatrixXd& curvature() const { return curvature_; }      // [1/m] at every knot from heights [m]

  ProfilePoints points(const Eigen::VectorXd& heights) const;  // of the samples
  // The heights whose curve comes nearest to a function of the position at the samples.
  Eigen::VectorXd fit(const std::function<double(double)>& height) const;

 private:
  void makeSpline();
  std::vector<double> knots_, positions_;
  Eigen::MatrixXd basis_, curvature_;
};

}  // namespace squat::estimation
