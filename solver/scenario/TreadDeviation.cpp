#include "scenario/TreadDeviation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/ElementaryFunctions.h"

namespace squat::scenario {

namespace {

constexpr double treadRunOut = 0.02;     // [m] over which an end that is not at zero runs out
constexpr double closedBelow = 0.04;     // [m] of a turn that is left open, below which the curve closes itself
constexpr double longestLocalDip = 0.3;  // [m]

// Points in arc from `origin`, with the rest of the turn closed.
TreadCurve closedCurve(const std::vector<ProfilePoint>& points, double origin, double radius) {
  std::vector<TreadCurve::Node> nodes;
  const double turn = 2 * std::numbers::pi * radius;
  const auto add = [&](double arc, double deviation) { nodes.push_back({(arc - origin) / radius, deviation, 0}); };
  const double open = turn - (points.back().position - points.front().position);
  const bool isOpen = open > closedBelow;
  if (isOpen && points.front().height != 0) add(points.front().position - treadRunOut, 0);
  for (const auto& point : points)
    if (point.position < points.front().position + turn * (1 - 1e-9)) add(point.position, point.height);
  if (isOpen && points.back().height != 0) add(points.back().position + treadRunOut, 0);
  return TreadCurve(std::move(nodes));
}

}  // namespace

TreadDeviation::TreadDeviation(const TreadShape& shape, double radius) : position_(shape.position) {
  std::vector<const std::vector<ProfilePoint>*> tables;
  for (const auto& line : shape.lines) tables.push_back(&line.points), lateral_.push_back(line.lateral);
  if (tables.empty()) tables.push_back(&shape.points);
  const ProfilePoint* deepest = nullptr;
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (const auto& point : *tables[i])
      if (!deepest || point.height < deepest->height) deepest = &point, deepestCurve_ = i;
  const bool sampled = std::all_of(tables.begin(), tables.end(), [](const auto* table) { return table->size() > 1; });
  if (!deepest || !sampled || !(radius > 0)) {
    lateral_.clear(), deepestCurve_ = 0;
    return;
  }
  for (const auto* table : tables) curves_.push_back(closedCurve(*table, deepest->position, radius));
  measure(radius);
}

void TreadDeviation::measure(double radius) {
  bool any = false;
  constexpr int parts = 4;  // of an interval, within which the curve is monotone
  for (const auto& curve : curves_) {
    const auto& nodes = curve.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      lowest_ = any ? std::min(lowest_, nodes[i].deviation) : nodes[i].deviation;
      highest_ = any ? std::max(highest_, nodes[i].deviation) : nodes[i].deviation;
      any = true;
      const double next = i + 1 < nodes.size() ? nodes[i + 1].angle : nodes[0].angle + 2 * std::numbers::pi;
      for (int k = 0; k < parts; ++k) {
        const double slope = curve.at(nodes[i].angle + (next - nodes[i].angle) * k / parts).slope;
        steepest_ = std::max(steepest_, std::abs(slope) / radius);
      }
    }
  }
  const double shallow = highest_ - 0.05 * (highest_ - lowest_);
  const auto& deepest = curves_[deepestCurve_];
  const double step = std::min(1e-3 / radius, 0.01), halfTurn = std::numbers::pi;
  double before = 0, behind = 0;
  while (before < halfTurn && deepest.at(-before).height < shallow) before += step;
  while (behind < halfTurn && deepest.at(behind).height < shallow) behind += step;
  dipBefore_ = before * radius, dipBehind_ = behind * radius;
  const auto& nodes = deepest.nodes();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    if (std::remainder(nodes[i + 1].angle, 2 * halfTurn) > -before &&
        std::remainder(nodes[i].angle, 2 * halfTurn) < behind)
      spacing_ = std::max(spacing_, (nodes[i + 1].angle - nodes[i].angle) * radius);
  isLocal_ = lowest_ < highest_ && dipBefore_ + dipBehind_ < longestLocalDip &&
             std::none_of(nodes.begin(), nodes.end(), [&](const auto& node) {
               const double angle = std::remainder(node.angle, 2 * halfTurn);
               return (angle < -before || angle > behind) && node.deviation < 0.5 * (lowest_ + highest_);
             });
}

double TreadDeviation::touchReach(double radius) const {
  return std::min(radius * steepest_, std::sqrt(2 * radius * (highest_ - lowest_)));
}

TreadCurve TreadDeviation::curveAt(double y) const {
  if (curves_.size() < 2) return curves_.empty() ? TreadCurve() : curves_.front();
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<double> angles;
  for (const auto& curve : curves_)
    for (const auto& node : curve.nodes()) angles.push_back(node.angle - turn * std::floor(node.angle / turn));
  std::sort(angles.begin(), angles.end());
  std::vector<TreadCurve::Node> nodes;
  for (const double angle : angles) {
    constexpr double same = 1e-9;  // [rad]
    if (!nodes.empty() && angle - nodes.back().angle < same) continue;
    std::vector<double> deviations;
    for (const auto& curve : curves_) deviations.push_back(curve.at(angle).height);
    nodes.push_back({angle, monotoneBetween(lateral_, deviations, y), 0});
  }
  return TreadCurve(std::move(nodes));
}

std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, const TreadDeviation& tread, double radius,
                                         double from, double to, double step, double y, double treadY) {
  if (tread.isRound()) return rigidWheelPath(surface, radius, from, to, step, y);
  std::vector<ProfilePoint> path;
  if (!(step > 0) || !(to >= from)) return path;
  const TreadCurve curve = tread.curveAt(treadY);
  double range = tread.highest() - tread.lowest(), highest = 0, lowest = 0;
  for (const auto& point : surface.samples()) {
    highest = std::max(highest, point.height);
    lowest = std::min(lowest, point.height);
  }
  range += highest - lowest;
  const double reach = std::sqrt(2 * radius * range);
  constexpr double fine = 0.0002;  // [m]
  const int half = static_cast<int>(std::ceil(reach / fine)) + 1;
  const auto count = static_cast<long>(std::floor((to - from) / step + 1e-9));
  for (long i = 0; i <= count; ++i) {
    const double x = from + static_cast<double>(i) * step;
    const double below = tread.angleAt(x, radius);
    double height = -radius;
    for (int k = -half; k <= half; ++k) {
      const double s = std::clamp(k * fine, -0.99 * radius, 0.99 * radius);
      const double r = radius + curve.at(below + elementary::asin(s / radius)).height;
      height = std::max(height, surface.height(x + s, y) + std::sqrt(r * r - s * s) - radius);
    }
    path.push_back({x, height});
  }
  return path;
}

}  // namespace squat::scenario
