#include "simulation/TracksideSensors.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/ElementaryFunctions.h"
#include "core/Errors.h"

namespace squat::simulation {

namespace {

// The nodes of the section closest to a point: one, or two on either side of it.
std::vector<int> nearestNodes(const elasticity::SweptBlock& block, double first, double second) {
  std::vector<double> distances;
  for (const auto& p : block.section.nodes) distances.push_back(elementary::hypot(p[0] - first, p[1] - second));
  const double minimum = *std::min_element(distances.begin(), distances.end());
  std::vector<int> nodes;
  for (std::size_t n = 0; n < distances.size(); ++n)
    if (distances[n] < minimum + 1e-9) nodes.push_back(static_cast<int>(n));
  return nodes;
}

// Vertical motion of one node at one station, its local components turned to the vertical.
void addVertical(const elasticity::SweptBlock& block, int node, int station, double weight, VerticalMotion& motion) {
  const Eigen::Matrix3d basis = elasticity::localBasis(block, block.positions[static_cast<std::size_t>(station)]);
  for (int c = 0; c < 3; ++c)
    if (std::abs(basis(2, c)) > 1e-12) motion.emplace_back(block.index(node, c, station), weight * basis(2, c));
}

// Mean of the nodes, interpolated linearly between the two stations beside `at`.
VerticalMotion between(const elasticity::SweptBlock& block, const std::vector<int>& nodes, double at) {
  const auto& stations = block.positions;
  const auto above = std::upper_bound(stations.begin() + 1, stations.begin() + block.intervals, at);
  const int right = static_cast<int>(above - stations.begin());
  const double left = stations[static_cast<std::size_t>(right - 1)];
  const double share = (at - left) / (stations[static_cast<std::size_t>(right)] - left);
  VerticalMotion motion;
  for (const int node : nodes) {
    const double weight = 1.0 / static_cast<double>(nodes.size());
    if (share < 1) addVertical(block, node, right - 1, (1 - share) * weight, motion);
    if (share > 0) addVertical(block, node, right, share * weight, motion);
  }
  return motion;
}

}  // namespace

VerticalMotion railFootAt(const model::Model& model, double x) {
  const auto& rail = model.blocks[static_cast<std::size_t>(model.rail)];
  const double from = rail.positions.front(), to = rail.positions[static_cast<std::size_t>(rail.intervals)];
  if (!(x >= from && x <= to))
    throw CaseError({{"output.rail_accelerometer", std::to_string(x) + " m",
                      std::to_string(from) + " to " + std::to_string(to) + " m, the rail of this case",
                      "Move the sensor, or lengthen the track with track.length"}});
  double lowest = 0;
  for (const auto& p : rail.section.nodes) lowest = std::min(lowest, p[1]);
  return between(rail, nearestNodes(rail, 0, lowest), x);
}

VerticalMotion sleeperTopNear(const model::Model& model, double x) {
  const auto& centres = model.sleeperPositions;
  const auto nearest = std::min_element(centres.begin(), centres.end(),
                                        [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
  const auto& sleeper =
      model.blocks[static_cast<std::size_t>(model.firstSleeper) + static_cast<std::size_t>(nearest - centres.begin())];
  return between(sleeper, nearestNodes(sleeper, 0, 0), 0);
}

Accelerometer::Accelerometer(VerticalMotion motion, const dynamics::Rolling& rolling)
    : motion_(std::move(motion)), last_(velocity(rolling)) {}

double Accelerometer::velocity(const dynamics::Rolling& rolling) const {
  double sum = 0;
  for (const auto& [unknown, weight] : motion_) sum += weight * rolling.state().velocity[unknown];
  return sum;
}

double Accelerometer::operator()(const dynamics::Rolling& rolling) {
  const double now = velocity(rolling), before = std::exchange(last_, now);
  return (now - before) / rolling.stepSize();
}

}  // namespace squat::simulation
