#include "calibration/Knowledge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace squat::calibration {
namespace {

// A best point whose data residuals are those of a model that fits: as many as given, each of size one.
Evaluation fitting(std::size_t samples) {
  Evaluation best;
  TargetValue data;
  for (std::size_t i = 0; i < samples; ++i) data.residuals.push_back(i % 2 == 0 ? 1 : -1);
  best.targets = {data};
  return best;
}

Targets oneSignal() {
  Targets targets;
  targets.signals.push_back({});
  return targets;
}

// Tables of chi-square (0.95): 3.841 is missed by Wilson and Hilferty by 2.5 %, the others by less than 1 %.
TEST(Knowledge, QuantileOfChiSquare) {
  EXPECT_NEAR(chiSquareQuantile95(1), 3.841, 0.1);
  EXPECT_NEAR(chiSquareQuantile95(2), 5.991, 0.06);
  EXPECT_NEAR(chiSquareQuantile95(5), 11.070, 0.06);
  EXPECT_NEAR(chiSquareQuantile95(10), 18.307, 0.06);
}

// Independent slopes of known size: an input may move by sqrt(quantile * s2) / |slope column|, all others at the best.
TEST(Knowledge, RangeOfLinearDataIsThatOfTheConfidenceEllipsoid) {
  constexpr std::size_t samples = 60;
  const auto best = fitting(samples);
  LinearModel model;
  model.centre = {0.5, 0.5};
  model.first = {0, samples};
  model.residuals = Eigen::Map<const Eigen::VectorXd>(best.targets[0].residuals.data(), samples);
  model.slope = Eigen::MatrixXd::Zero(samples, 2);
  // Square to the residuals and to each other: + + 0 0 and 0 0 + + in turn.
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(samples); ++i)
    model.slope(i, (i / 2) % 2) = (i / 2) % 2 ? 2 : 8;
  const EquallyGood isEquallyGood(oneSignal(), best, 2);
  const double allowed = std::max(1.0, 60.0 / 58.0) * chiSquareQuantile95(2);
  const double first = std::sqrt(allowed / model.slope.col(0).squaredNorm());
  Eigen::VectorXd way = Eigen::VectorXd::Zero(2);
  way[0] = 0.99 * first;
  EXPECT_TRUE(isEquallyGood(model, way));
  way[0] = 1.01 * first;
  EXPECT_FALSE(isEquallyGood(model, way));
  const auto points = equallyGoodByModel(isEquallyGood, model, 400);
  double low = 1, high = 0;
  for (const auto& point : points) low = std::min(low, point[0]), high = std::max(high, point[0]);
  // A walk of 400 points in the ellipse comes within a tenth of its ends (a share of 0.03 of the area lies beyond).
  EXPECT_NEAR(low, 0.5 - first, 0.1 * first);
  EXPECT_NEAR(high, 0.5 + first, 0.1 * first);
}

TEST(Knowledge, StatementsThatTheBestMeetsMustBeMet) {
  Targets targets;
  targets.statements.resize(2);
  Evaluation best;
  best.targets.resize(2);
  best.targets[0].isMet = true;
  const EquallyGood isEquallyGood(targets, best, 1);
  auto other = best;
  EXPECT_TRUE(isEquallyGood(other));
  other.targets[1].isMet = true;  // one more does no harm
  EXPECT_TRUE(isEquallyGood(other));
  other.targets[0].isMet = false;
  EXPECT_FALSE(isEquallyGood(other));
  // What the best misses may be missed a tenth more, no further.
  auto near = best, far = best;
  best.targets[1].residuals = {2.0}, near.targets[1].residuals = {2.1}, far.targets[1].residuals = {2.5};
  const EquallyGood isAsGood(targets, best, 1);
  EXPECT_TRUE(isAsGood(near));
  EXPECT_FALSE(isAsGood(far));
  best.hasFailed = true;
  EXPECT_FALSE(isEquallyGood(best));
}

TEST(Knowledge, SpreadOutTakesTheFarthest) {
  const std::vector<UnitPoint> points{{0.5}, {0.52}, {0.1}, {0.9}, {0.3}};
  const auto chosen = spreadOut(points, 3);
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen[0][0], 0.5);
  EXPECT_NEAR(chosen[1][0] + chosen[2][0], 1.0, 1e-12);  // 0.1 and 0.9
  EXPECT_EQ(spreadOut(points, 9).size(), 5u);
}

}  // namespace
}  // namespace squat::calibration
