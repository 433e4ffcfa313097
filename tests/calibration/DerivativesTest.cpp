#include "calibration/Derivatives.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::calibration {
namespace {

std::vector<FreeInput> twoInputs() { return freeInputsFromText({"pad.stiffness=1:1001", "pad.damping=0:100"}); }

// Residuals that are linear in the inputs: two targets, of three residuals and of one.
Evaluation linear(const std::vector<FreeInput>& inputs, const UnitPoint& x) {
  Evaluation evaluation;
  evaluation.values = valuesAt(inputs, x);
  const auto point = pointOf(inputs, evaluation.values);  // what the rounded values stand for
  TargetValue first, second;
  first.residuals = {2 * point[0] - 1.2, point[0] + point[1] - 0.9, 3 * point[1] - 0.9};
  second.residuals = {point[0] - 0.6};
  evaluation.targets = {first, second};
  return evaluation;
}

TEST(Derivatives, OfLinearResidualsAreTheirSlopes) {
  const auto inputs = twoInputs();
  const auto centre = linear(inputs, {0.5, 0.5});
  std::vector<Evaluation> about;
  for (const auto& point : pointsAbout({0.5, 0.5}, 0.04)) about.push_back(linear(inputs, point));
  const auto model = linearModel(inputs, centre, about);
  Eigen::MatrixXd expected(4, 2);
  expected << 2, 0, 1, 1, 0, 3, 1, 0;
  EXPECT_LT((model.slope - expected).cwiseAbs().maxCoeff(), 1e-4);  // values have six digits
}

// All residuals vanish at (0.6, 0.3).
TEST(Derivatives, NewtonsStepEndsWhereLinearResidualsVanish) {
  const auto inputs = twoInputs();
  const auto centre = linear(inputs, {0.2, 0.9});
  std::vector<Evaluation> about;
  for (const auto& point : pointsAbout({0.2, 0.9}, 0.04)) about.push_back(linear(inputs, point));
  const auto next = newtonPoint(linearModel(inputs, centre, about), {1, 1}, 0);
  EXPECT_NEAR(next[0], 0.6, 1e-3);
  EXPECT_NEAR(next[1], 0.3, 1e-3);
}

TEST(Derivatives, PointsStayInTheCube) {
  for (const auto& point : pointsAbout({0.0, 0.99}, 0.04))
    for (const double c : point) EXPECT_TRUE(c >= 0 && c <= 1);
  EXPECT_EQ(pointsAbout({0.0, 0.99}, 0.04).size(), 3u);  // nothing below the lower limit
}

TEST(Derivatives, OneSidedWhereTheOtherPointFailed) {
  const auto inputs = twoInputs();
  std::vector<Evaluation> about;
  for (const auto& point : pointsAbout({0.5, 0.5}, 0.04)) about.push_back(linear(inputs, point));
  about[0].hasFailed = true, about[0].targets.clear();
  const auto model = linearModel(inputs, linear(inputs, {0.5, 0.5}), about);
  EXPECT_NEAR(model.slope(0, 0), 2, 1e-3);
}

}  // namespace
}  // namespace squat::calibration
