#include "calibration/Knowledge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "calibration/StatementResiduals.h"
#include "statements/Judge.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::calibration {

namespace {

double squaresOf(const std::vector<double>& residuals) {
  double sum = 0;
  for (const double residual : residuals) sum += residual * residual;
  return sum;
}

double distance(const UnitPoint& a, const UnitPoint& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

std::vector<std::vector<double>> correlationOf(const std::vector<UnitPoint>& points) {
  const std::size_t n = points.front().size();
  std::vector<double> mean(n);
  for (const auto& point : points)
    for (std::size_t i = 0; i < n; ++i) mean[i] += point[i] / static_cast<double>(points.size());
  std::vector<std::vector<double>> covariance(n, std::vector<double>(n));
  for (const auto& point : points)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) covariance[i][k] += (point[i] - mean[i]) * (point[k] - mean[k]);
  auto correlation = covariance;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double scale = std::sqrt(covariance[i][i] * covariance[k][k]);
      correlation[i][k] = scale > 0 ? covariance[i][k] / scale : (i == k ? 1.0 : 0.0);
    }
  return correlation;
}

InputRange rangeOf(const FreeInput& input, std::size_t index, double best, const std::vector<UnitPoint>& points,
                   const LinearModel& model) {
  constexpr double atLimit = 0.02, faint = 0.3;
  double low = 1, high = 0;
  for (const auto& point : points) low = std::min(low, point[index]), high = std::max(high, point[index]);
  const auto value = [&](double share) { return input.low + share * (input.high - input.low); };
  InputRange range;
  range.best = best;
  range.low = std::min(value(low), best), range.high = std::max(value(high), best);
  range.reachesLow = low < atLimit;
  range.reachesHigh = 1 - high < atLimit;
  // Over the whole way between its limits it would move no residual by a third of what is allowed.
  const bool isLimited = !(range.reachesLow && range.reachesHigh);
  range.isSeen = isLimited || model.slope.rows() == 0 ||
                 model.slope.col(static_cast<Eigen::Index>(index)).cwiseAbs().maxCoeff() > faint;
  return range;
}

void findOutOfReach(Calibration& calibration) {
  constexpr double farOff = 5;  // times the noise or tolerance
  const auto& targets = calibration.definition.targets;
  const auto names = targets.names();
  for (std::size_t t = 0; t < names.size(); ++t) {
    const bool isStatement = t < targets.statements.size();
    const auto away = [&](const TargetValue& target) {
      return isStatement ? std::abs(statementResidual(targets.statements[t].statement, *target.value)) : *target.value;
    };
    const TargetValue* nearest = nullptr;
    for (const auto& row : calibration.evaluations)
      if (!row.hasFailed && row.targets[t].value && (!nearest || away(row.targets[t]) < away(*nearest)))
        nearest = &row.targets[t];
    if (nearest && (isStatement ? nearest->isMet : *nearest->value < farOff)) continue;
    std::string text = "'" + names[t] + "'";
    if (isStatement) {
      const auto& statement = targets.statements[t].statement;
      text += " asks for " + statements::rangeText(statement) + "; ";
      text += nearest ? "the nearest that any point gives is " + text::roundedText(*nearest->value) +
                            (statement.unit == "1" ? "" : " " + text::printedUnit(statement.unit))
                      : "it cannot be determined at any point";
    } else {
      text += nearest ? ": at every point the residuals are at least " + text::roundedText(*nearest->value) +
                            " times what is allowed"
                      : " cannot be compared at any point";
    }
    calibration.outOfReach.push_back(text);
  }
}

}  // namespace

double chiSquareQuantile95(std::size_t degrees) {
  constexpr double normalQuantile95 = 1.6448536269514722;
  const double k = static_cast<double>(degrees), ninth = 2 / (9 * k);
  return k * std::pow(1 - ninth + normalQuantile95 * std::sqrt(ninth), 3);
}

EquallyGood::EquallyGood(const Targets& targets, const Evaluation& best, std::size_t inputs)
    : statements_(targets.statements.size()) {
  double squares = 0;
  for (std::size_t t = 0; t < best.targets.size(); ++t) {
    if (t < statements_) {
      const auto& residuals = best.targets[t].residuals;
      const double away = residuals.empty() ? kMissingResidual : std::abs(residuals.front());
      largest_.push_back(best.targets[t].isMet ? 1 : 1.1 * std::max(1.0, away));
      continue;
    }
    squares += squaresOf(best.targets[t].residuals);
    samples_ += best.targets[t].residuals.size();
  }
  const double free = samples_ > inputs ? static_cast<double>(samples_ - inputs) : 1;
  largestSquares_ = squares + std::max(1.0, squares / free) * chiSquareQuantile95(std::max<std::size_t>(inputs, 1));
}

bool EquallyGood::accepts(const std::vector<double>& away, double squares) const {
  for (std::size_t t = 0; t < statements_; ++t)
    if (away[t] > largest_[t]) return false;
  return samples_ == 0 || squares <= largestSquares_;
}

bool EquallyGood::operator()(const Evaluation& evaluation) const {
  if (evaluation.hasFailed) return false;
  std::vector<double> away;  // a statement that is not met lies beyond its limit, if only by rounding
  double squares = 0;
  std::size_t samples = 0;
  for (std::size_t t = 0; t < evaluation.targets.size(); ++t) {
    const auto& target = evaluation.targets[t];
    if (t < statements_)
      away.push_back(target.isMet               ? 0
                     : target.residuals.empty() ? kMissingResidual
                                                : std::max(std::abs(target.residuals.front()), 1 + 1e-9));
    else
      squares += squaresOf(target.residuals), samples += target.residuals.size();
  }
  return samples == samples_ && accepts(away, squares);
}

bool EquallyGood::operator()(const LinearModel& model, const Eigen::VectorXd& way) const {
  const Eigen::VectorXd residuals = model.residuals + model.slope * way;
  std::vector<double> away;
  for (std::size_t t = 0; t < statements_; ++t)
    away.push_back(std::abs(residuals[static_cast<Eigen::Index>(model.first[t])]));
  const auto data = residuals.size() - static_cast<Eigen::Index>(model.first[statements_]);
  return accepts(away, residuals.tail(data).squaredNorm());
}

std::vector<UnitPoint> equallyGoodByModel(const EquallyGood& isEquallyGood, const LinearModel& model,
                                          std::size_t count) {
  constexpr int stepsForEach = 40;
  const auto n = static_cast<Eigen::Index>(model.centre.size());
  std::mt19937_64 random(20261123);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto inCube = [&](const Eigen::VectorXd& way) {
    for (Eigen::Index i = 0; i < n; ++i)
      if (model.centre[i] + way[i] < 0 || model.centre[i] + way[i] > 1) return false;
    return true;
  };
  std::vector<UnitPoint> points;
  Eigen::VectorXd way = Eigen::VectorXd::Zero(n);
  for (std::size_t p = 0; p < count; ++p) {
    for (int step = 0; step < stepsForEach; ++step) {
      Eigen::VectorXd direction(n);
      for (Eigen::Index i = 0; i < n; ++i) direction[i] = normal(random);
      // From far to near, until a place is found that is equally good: hit and run without the exact ends.
      double reach = 2 * (uniform(random) - 0.5) * 2 / direction.norm();
      for (int halving = 0; halving < 8; ++halving, reach *= 0.5) {
        const Eigen::VectorXd next = way + reach * direction;
        if (!inCube(next) || !isEquallyGood(model, next)) continue;
        way = next;
        break;
      }
    }
    UnitPoint point = model.centre;
    for (Eigen::Index i = 0; i < n; ++i) point[i] += way[i];
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<UnitPoint> spreadOut(const std::vector<UnitPoint>& points, std::size_t count) {
  std::vector<UnitPoint> chosen;
  while (!points.empty() && chosen.size() < std::min(count, points.size())) {
    const UnitPoint* farthest = nullptr;
    double maximum = -1;
    for (const auto& point : points) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& other : chosen) nearest = std::min(nearest, distance(point, other));
      if (nearest > maximum) maximum = nearest, farthest = &point;
    }
    chosen.push_back(*farthest);
  }
  return chosen;
}

void summarise(Calibration& calibration, const EquallyGood& isEquallyGood, const LinearModel& model,
               const std::vector<UnitPoint>& byModel) {
  constexpr std::size_t enough = 8;
  const auto& inputs = calibration.definition.inputs;
  std::vector<UnitPoint> points;
  for (std::size_t i = 0; i < calibration.evaluations.size(); ++i) {
    const auto& row = calibration.evaluations[i];
    if (row.mesh != calibration.definition.searchMesh || !isEquallyGood(row)) continue;
    calibration.equallyGood.push_back(i);
    points.push_back(pointOf(inputs, row.values));
  }
  // Data: what noise leaves open is known from the derivatives. Statements: only points that were computed count.
  if (isEquallyGood.hasData()) points.insert(points.end(), byModel.begin(), byModel.end());
  const auto& best = calibration.evaluations[calibration.best];
  for (std::size_t i = 0; i < inputs.size(); ++i)
    calibration.ranges.push_back(rangeOf(inputs[i], i, best.values[i], points, model));
  if (points.size() >= enough) calibration.correlation = correlationOf(points);
  findOutOfReach(calibration);
}

}  // namespace squat::calibration
