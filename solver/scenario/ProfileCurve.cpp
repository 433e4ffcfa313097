#include "scenario/ProfileCurve.h"

#include <algorithm>
#include <cmath>

namespace squat::scenario {

namespace {

constexpr double runOut = 0.02;  // [m] over which an end that is not at zero runs out

// One-sided slope at an end, three points, kept monotone (as in Fritsch and Butland's code).
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

}  // namespace

ProfileCurve::ProfileCurve(const std::vector<ProfilePoint>& points, double scale, bool ends) {
  if (points.size() < 2) return;
  for (const auto& point : points) nodes_.push_back({point.position, point.height * scale, 0});
  level(ends);
}

void ProfileCurve::level(bool ends) {
  const Node start = nodes_.front(), end = nodes_.back();
  if (ends) {
    const double grade = (end.height - start.height) / (end.position - start.position);
    for (auto& node : nodes_) node.height -= start.height + grade * (node.position - start.position);
    nodes_.front().height = nodes_.back().height = 0;
    return;
  }
  if (start.height != 0) nodes_.insert(nodes_.begin(), {start.position - runOut, 0, 0});
  if (end.height != 0) nodes_.push_back({end.position + runOut, 0, 0});
}

ProfilePoint ProfileCurve::deepest() const {
  const auto lowest =
      std::min_element(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.height < b.height; });
  return lowest == nodes_.end() ? ProfilePoint{} : ProfilePoint{lowest->position, lowest->height};
}

void ProfileCurve::finish(double origin) {
  for (auto& node : nodes_) node.position -= origin;
  trim();
  findSlopes();
}

void ProfileCurve::trim() {
  const auto rises = [](const Node& node) { return node.height != 0; };
  const auto firstRise = std::find_if(nodes_.begin(), nodes_.end(), rises);
  if (firstRise == nodes_.end()) {
    nodes_.clear();
    return;
  }
  const auto behindLast = std::find_if(nodes_.rbegin(), nodes_.rend(), rises).base();
  if (behindLast != nodes_.end()) nodes_.erase(behindLast + 1, nodes_.end());
  if (firstRise != nodes_.begin()) nodes_.erase(nodes_.begin(), firstRise - 1);
}

void ProfileCurve::findSlopes() {
  const std::size_t n = nodes_.size();
  if (n < 3) return;
  const auto width = [&](std::size_t i) { return nodes_[i + 1].position - nodes_[i].position; };
  const auto secant = [&](std::size_t i) { return (nodes_[i + 1].height - nodes_[i].height) / width(i); };
  for (std::size_t i = 1; i + 1 < n; ++i)
    nodes_[i].slope = innerSlope(width(i - 1), width(i), secant(i - 1), secant(i));
  // Ends that join the plane rail do so without a kink; endSlope is for levelled data whose end is not at rest.
  if (nodes_.front().height != 0) nodes_.front().slope = endSlope(width(0), width(1), secant(0), secant(1));
  if (nodes_.back().height != 0)
    nodes_.back().slope = endSlope(width(n - 2), width(n - 3), secant(n - 2), secant(n - 3));
}

HeightAndSlope ProfileCurve::at(double x) const {
  if (nodes_.empty() || !(x >= first() && x < last())) return {};
  const auto next = std::upper_bound(nodes_.begin(), nodes_.end(), x,
                                     [](double value, const Node& node) { return value < node.position; });
  const Node &b = *next, &a = *(next - 1);
  return hermite(x - a.position, b.position - a.position, a.height, b.height, a.slope, b.slope);
}

std::vector<ProfilePoint> ProfileCurve::points() const {
  std::vector<ProfilePoint> list;
  for (const auto& node : nodes_) list.push_back({node.position, node.height});
  return list;
}

double monotoneBetween(const std::vector<double>& positions, const std::vector<double>& values, double y) {
  const std::size_t n = positions.size();
  if (y <= positions.front()) return values.front();
  if (y >= positions.back()) return values.back();
  const auto k =
      static_cast<std::size_t>(std::upper_bound(positions.begin(), positions.end(), y) - positions.begin()) - 1;
  const auto width = [&](std::size_t i) { return positions[i + 1] - positions[i]; };
  const auto secant = [&](std::size_t i) { return (values[i + 1] - values[i]) / width(i); };
  // The outermost lines go on level, so the slope there is zero.
  const auto slope = [&](std::size_t i) {
    return i == 0 || i + 1 == n ? 0.0 : innerSlope(width(i - 1), width(i), secant(i - 1), secant(i));
  };
  return hermite(y - positions[k], width(k), values[k], values[k + 1], slope(k), slope(k + 1)).height;
}

}  // namespace squat::scenario
