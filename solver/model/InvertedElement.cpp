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

// Largest difference of a component between nodes of each element of a run: a plain loop along the stations, because
// all elements of the model pass here.
void differences(const SweptBlock& block, const std::array<int, 4>& quad, int first, int last, const double* u,
                 std::vector<double>& largest) {
  largest.assign(static_cast<std::size_t>(last - first), 0.0);
  for (int c = 0; c < 3; ++c) {
    const auto base = block.line(u, quad[0], c);
    for (const int node : quad) {
      const auto line = block.line(u, node, c);
      for (int s = first; s < last; ++s)
        largest[s - first] =
            std::max({largest[s - first], std::abs(line[s] - base[s]), std::abs(line[s + 1] - base[s])});
    }
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

}  // namespace

std::string invertedElement(const Model& model, const AlignedVector& displacement) {
  // Nodes of an element then differ by less than 7 % of its shortest edge, which turns over no element whose worst
  // corner has a fifth of the centre's Jacobian. Healthy runs strain by less than a hundredth: almost nothing passes.
  constexpr double harmless = 0.02;
  const double* u = displacement.data();
  std::vector<double> largest;
  for (const auto& block : model.blocks)
    for (std::size_t r = 0; r < block.runIntervals.size(); ++r) {
      const double length = block.stations.runs[r].length;
      const auto turn = elasticity::localToMiddle(block, length);
      const auto [first, last] = block.runIntervals[r];
      for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q) {
        const auto& quad = block.section.quads[q];
        const auto corners = elasticity::elementCorners(block, q, length);
        const double allowed = harmless * shortestEdge(corners);
        differences(block, quad, first, last, u, largest);
        for (int s = first; s < last; ++s)
          if (largest[s - first] > allowed && inverted(block, quad, s, corners, turn, u))
            return elementLocation(block, q, s);
      }
    }
  return {};
}

}  // namespace squat::model
