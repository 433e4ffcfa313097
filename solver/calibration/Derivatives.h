// solver/calibration/Derivatives.h - residuals of all targets about one point, as a linear model.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/Calibration.h"

namespace squat::calibration {

// Residuals of all targets one after the other at `centre` plus `slope` times the way in the unit cube.
struct LinearModel {
  UnitPoint centre;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slope;           // a column for each input
  std::vector<std::size_t> first;  // of each target's residuals, one entry more
};

// The points to evaluate for it: each input to both sides of the centre, as far as the cube allows.
std::vector<UnitPoint> pointsAbout(const UnitPoint& centre, double step);

// From the evaluations at the centre and at these points; inputs both of whose points failed, or gave another number of
// residuals, get no slope.
LinearModel linearModel(const std::vector<FreeInput>& inputs, const Evaluation& centre,
                        const std::vector<Evaluation>& about);

// The step of Gauss and Newton with Levenberg's damping relative to the largest curvature, kept in the cube. Residuals
// of a target are weighted like its misfit.
UnitPoint newtonPoint(const LinearModel& model, const std::vector<double>& weights, double damping);

}  // namespace squat::calibration
