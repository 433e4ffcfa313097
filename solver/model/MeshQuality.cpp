#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>

#include "model/Model.h"

namespace squat::model {

std::string elementLocation(const elasticity::SweptBlock& block, int quad, int interval) {
  Eigen::Vector3d centre(0, 0, 0);
  for (const int n : block.section.quads[quad]) centre += 0.25 * elasticity::nodePosition(block, n, interval);
  char text[160];
  std::snprintf(text, sizeof text, "%s, section quad %d, interval %d at x %.4f, y %.4f, z %.4f m", block.name.c_str(),
                quad, interval, centre[0], centre[1], centre[2]);
  return text;
}

MeshQuality meshQuality(const Model& model) {
  MeshQuality quality;
  for (const auto& block : model.blocks)
    for (std::size_t r = 0; r < block.runIntervals.size(); ++r)
      for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q) {
        const auto corners = elasticity::elementCorners(block, q, block.stations.runs[r].length);
        const double jacobian = elasticity::jacobianRatio(corners);
        if (jacobian < quality.smallestJacobian) {
          quality.smallestJacobian = jacobian;
          quality.jacobianLocation = elementLocation(block, q, block.runIntervals[r][0]);
        }
        double shortest = 1e30, longest = 0;
        for (int i = 0; i < 4; ++i) {
          const double edges[2] = {(corners[i] - corners[(i + 1) % 4]).norm(), (corners[i] - corners[i + 4]).norm()};
          for (const double edge : edges) shortest = std::min(shortest, edge), longest = std::max(longest, edge);
        }
        if (longest / shortest > quality.largestAspect) {
          quality.largestAspect = longest / shortest;
          quality.aspectLocation = elementLocation(block, q, block.runIntervals[r][0]);
        }
      }
  return quality;
}

std::string locationName(const Model& model, std::size_t index) {
  for (const auto& block : model.blocks) {
    if (index < block.offset || index >= block.offset + block.size()) continue;
    const auto [node, component, s] = block.unknownAt(index);
    const Eigen::Vector3d p = elasticity::nodePosition(block, node, std::min(s, block.intervals));
    char text[160];
    std::snprintf(text, sizeof text, "%s, node %d of station %d at x %.4f, y %.4f, z %.4f m", block.name.c_str(), node,
                  s, p[0], p[1], p[2]);
    return text;
  }
  return index >= model.boxX && index <= model.boxZ ? "axle box" : "sprung mass";
}

}  // namespace squat::model
