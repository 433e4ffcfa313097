#include "calibration/Derivatives.h"

#include <algorithm>
#include <cmath>

#include "core/DenseAlgebra.h"

namespace squat::calibration {

namespace {

Eigen::VectorXd residualsOf(const Evaluation& evaluation) {
  std::vector<double> all;
  for (const auto& target : evaluation.targets) all.insert(all.end(), target.residuals.begin(), target.residuals.end());
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

std::vector<UnitPoint> pointsAbout(const UnitPoint& centre, double step) {
  std::vector<UnitPoint> points;
  for (std::size_t i = 0; i < centre.size(); ++i)
    for (const double way : {step, -step}) {
      UnitPoint point = centre;
      point[i] = std::clamp(centre[i] + way, 0.0, 1.0);
      if (point[i] != centre[i]) points.push_back(std::move(point));
    }
  return points;
}

LinearModel linearModel(const std::vector<FreeInput>& inputs, const Evaluation& centre,
                        const std::vector<Evaluation>& about) {
  LinearModel model;
  model.centre = pointOf(inputs, centre.values);
  model.residuals = residualsOf(centre);
  model.first.push_back(0);
  for (const auto& target : centre.targets) model.first.push_back(model.first.back() + target.residuals.size());
  const auto n = static_cast<Eigen::Index>(inputs.size());
  model.slope = Eigen::MatrixXd::Zero(model.residuals.size(), n);
  for (Eigen::Index i = 0; i < n; ++i) {
    // The points that differ from the centre in this input alone: the outermost two, or one and the centre.
    double low = model.centre[i], high = low;
    Eigen::VectorXd atLow = model.residuals, atHigh = model.residuals;
    for (const auto& evaluation : about) {
      const auto point = pointOf(inputs, evaluation.values);
      bool isAlone = !evaluation.hasFailed;
      for (Eigen::Index k = 0; k < n && isAlone; ++k) isAlone = k == i || std::abs(point[k] - model.centre[k]) < 1e-6;
      if (!isAlone) continue;
      const auto residuals = residualsOf(evaluation);
      if (residuals.size() != model.residuals.size()) continue;
      if (point[i] < low) low = point[i], atLow = residuals;
      if (point[i] > high) high = point[i], atHigh = residuals;
    }
    if (high > low) model.slope.col(i) = (atHigh - atLow) / (high - low);
  }
  return model;
}

UnitPoint newtonPoint(const LinearModel& model, const std::vector<double>& weights, double damping) {
  Eigen::VectorXd weight(model.residuals.size());
  for (std::size_t t = 0; t + 1 < model.first.size(); ++t)
    for (std::size_t r = model.first[t]; r < model.first[t + 1]; ++r)
      weight[static_cast<Eigen::Index>(r)] = weights[t] / static_cast<double>(model.first[t + 1] - model.first[t]);
  const Eigen::MatrixXd curvature = model.slope.transpose() * weight.asDiagonal() * model.slope;
  const Eigen::VectorXd slope = model.slope.transpose() * weight.asDiagonal() * model.residuals;
  const double diagonal = std::max(curvature.diagonal().maxCoeff(), 1e-12);
  const Eigen::MatrixXd damped =
      curvature + (damping + 1e-9) * diagonal * Eigen::MatrixXd::Identity(curvature.rows(), curvature.cols());
  const Eigen::VectorXd step = -algebra::solveSymmetric(damped, slope);
  UnitPoint point = model.centre;
  for (std::size_t i = 0; i < point.size(); ++i)
    point[i] = std::clamp(point[i] + step[static_cast<Eigen::Index>(i)], 0.0, 1.0);
  return point;
}

}  // namespace squat::calibration
