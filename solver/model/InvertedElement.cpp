#include "model/InvertedElement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace squat::model {

namespace {

using elasticity::Corners;
using elasticity::SweptBlock;

double shortestEdge(const Corners& corners) {
  double shortest = 1e30;
  for (int i = 0; i < 4; ++i)
    shortest = std::min({shortest, (corners[i] - corners[(i + 1) % 4]).norm(),
                         (corners[i + 4] - corners[(i + 1) % 4 + 4]).norm(), (corners[i] - corners[i + 4]).norm()});
  return shortest;
}

// For each element of a run, no less than the largest difference of a component between its nodes: within its sections,
// and from one to the next along a node. Plain loops along eight stations, because all elements of the model pass here.
void differences(const SweptBlock& block, const std::array<int, 4>& quad, int first, int last, const double* u,
                 std::vector<double>& largest) {
  constexpr int lanes = 8;  // runs are multiples of eight, and so are chunks
  const auto stations = static_cast<std::size_t>(last - first) + 1;
  largest.assign(stations, 0.0);
  const auto widen = [](double& to, double by) { to = by > to ? by : to; };
  for (int c = 0; c < 3; ++c) {
    const auto base = block.line(u, quad[0], c);
    for (int k = 1; k < 4; ++k) {
      const auto line = block.line(u, quad[k], c);
      for (int s = first; s < last; s += lanes) {
        const double *own = &line[s], *other = &base[s];
        double* to = &largest[static_cast<std::size_t>(s - first)];
        for (int i = 0; i < lanes; ++i) widen(to[i], std::abs(own[i] - other[i]));
      }
      widen(largest.back(), std::abs(line[last] - base[last]));
    }
  }
  for (int s = first; s < last; ++s) {
    double along = 0;
    for (int c = 0; c < 3; ++c) {
      const auto base = block.line(u, quad[0], c);
      widen(along, std::abs(base[s + 1] - base[s]));
    }
    const auto at = static_cast<std::size_t>(s - first);
    largest[at] = std::max(largest[at], largest[at + 1] + along);
  }
}

bool inverted(const SweptBlock& block, const std::array<int, 4>& quad, int interval, const Corners& corners,
              const elasticity::Matrix24& turn, const double* u) {
  Corners displaced = corners;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d local;
    for (int c = 0; c < 3; ++c) local[c] = u[block.index(quad[corner % 4], c, interval + corner / 4)];
    displaced[corner] += turn.block<3, 3>(3 * corner, 3 * corner) * local;
  }
  // The Jacobian at a corner is the mixed product of its three edges.
  for (int i = 0; i < 8; ++i) {
    const int next = i / 4 * 4 + (i + 1) % 4, previous = i / 4 * 4 + (i + 3) % 4;
    const Eigen::Vector3d along = displaced[i % 4 + 4] - displaced[i % 4];
    const Eigen::Vector3d across = (displaced[next] - displaced[i]).cross(displaced[previous] - displaced[i]);
    if (along.dot(across) <= 0) return true;
  }
  return false;
}

// Of one run of a block.
std::string invertedElement(const SweptBlock& block, std::size_t run, const double* u) {
  // Nodes of an element then differ by less than 7 % of its shortest edge, which turns over no element whose worst
  // corner has a fifth of the centre's Jacobian. Healthy runs strain by less than a hundredth: almost nothing passes.
  constexpr double harmless = 0.02;
  std::vector<double> largest;
  const double length = block.stations.runs[run].length;
  const auto turn = elasticity::localToMiddle(block, length);
  const auto [first, last] = block.runIntervals[run];
  for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q) {
    const auto& quad = block.section.quads[q];
    const auto corners = elasticity::elementCorners(block, q, length);
    const double allowed = harmless * shortestEdge(corners);
    differences(block, quad, first, last, u, largest);
    for (int s = first; s < last; ++s)
      if (largest[s - first] > allowed && inverted(block, quad, s, corners, turn, u))
        return elementLocation(block, q, s);
  }
  return {};
}

}  // namespace

std::string invertedElement(const Model& model, const AlignedVector& displacement, ThreadTeam* team) {
  std::vector<std::pair<const SweptBlock*, std::size_t>> runs;
  for (const auto& block : model.blocks)
    for (std::size_t r = 0; r < block.runIntervals.size(); ++r) runs.emplace_back(&block, r);
  std::vector<std::string> found(runs.size());
  const auto look = [&](std::size_t i) {
    found[i] = invertedElement(*runs[i].first, runs[i].second, displacement.data());
  };
  if (team)
    team->forEach(runs.size(), look);
  else
    for (std::size_t i = 0; i < runs.size(); ++i) look(i);
  const auto first = std::find_if(found.begin(), found.end(), [](const auto& place) { return !place.empty(); });
  return first == found.end() ? std::string() : *first;
}

}  // namespace squat::model
