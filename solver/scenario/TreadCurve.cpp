#include "scenario/TreadCurve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace squat::scenario {

namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

}  // namespace

TreadCurve::TreadCurve(std::vector<Node> nodes) : nodes_(std::move(nodes)) {
  const std::size_t n = nodes_.size();
  if (n < 2) {
    nodes_.clear();
    return;
  }
  const auto width = [&](std::size_t i) {
    return i + 1 < n ? nodes_[i + 1].angle - nodes_[i].angle : nodes_[0].angle + fullTurn - nodes_[i].angle;
  };
  const auto secant = [&](std::size_t i) { return (nodes_[(i + 1) % n].deviation - nodes_[i].deviation) / width(i); };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    nodes_[i].slope = innerSlope(width(before), width(i), secant(before), secant(i));
  }
}

HeightAndSlope TreadCurve::at(double angle) const {
  if (nodes_.empty()) return {};
  const double first = nodes_.front().angle;
  double within = angle - fullTurn * std::floor((angle - first) / fullTurn);
  if (!(within >= first && within < first + fullTurn)) within = first;  // round-off, or a state that diverges
  const auto next = std::upper_bound(nodes_.begin(), nodes_.end(), within,
                                     [](double value, const Node& node) { return value < node.angle; });
  const Node &a = *(next - 1), &b = next == nodes_.end() ? nodes_.front() : *next;
  const double end = next == nodes_.end() ? first + fullTurn : next->angle;
  return hermite(within - a.angle, end - a.angle, a.deviation, b.deviation, a.slope, b.slope);
}

}  // namespace squat::scenario
