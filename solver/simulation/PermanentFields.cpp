// What the wheel leaves behind: change of the running surface, plastic strain and residual stress below it.
#include <algorithm>
#include <cmath>

#include "simulation/Describe.h"
#include "simulation/VonMises.h"

namespace squat::simulation {

namespace {

using Stress = Eigen::Matrix<double, 6, 1>;
constexpr double shownDepth = 0.020;  // [m] below the running surface: residual stress has faded there

// Nodes on the plane y = 0 from the running surface down.
std::vector<int> middleColumn(const elasticity::SweptBlock& rail) {
  auto nodes = geometry::nodesWhere(
      rail.section, [](const geometry::Point2& p) { return std::abs(p[0]) < 1e-9 && p[1] > -shownDepth; }, 1);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

struct NodeMean {
  Stress stress = Stress::Zero();
  double equivalent = 0;
  int count = 0;
};

// Stress and equivalent plastic strain at the centres of all elements around the column, averaged to its nodes.
std::vector<NodeMean> nodeMeans(const model::Model& model, const plasticity::LayerState& flow, const AlignedVector& u,
                                const std::vector<int>& column, int first, int count) {
  const auto& rail = model.blocks[model.rail];
  const auto hooke = elasticity::elasticityMatrix(rail.material);
  std::vector<NodeMean> means(static_cast<std::size_t>(count + 1) * column.size());
  for (int q = 0; q < static_cast<int>(rail.section.quads.size()); ++q) {
    const auto& quad = rail.section.quads[q];
    std::vector<std::size_t> inColumn;
    for (std::size_t i = 0; i < column.size(); ++i)
      if (std::find(quad.begin(), quad.end(), column[i]) != quad.end()) inColumn.push_back(i);
    if (inColumn.empty()) continue;
    for (int s = first; s < first + count; ++s) {
      const auto corners = elasticity::elementCorners(rail, q, rail.stations.runs[rail.runOf(s)].length);
      Eigen::Matrix<double, 24, 1> nodal;
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < 4; ++i)
          for (int c = 0; c < 3; ++c) nodal[12 * side + 3 * i + c] = u[rail.index(quad[i], c, s + side)];
      const auto own = elementFlow(model.layer, flow, q, s);
      const Stress stress =
          hooke * (elasticity::centreStrain(corners) * nodal - Eigen::Map<const Stress>(own.strain.data()));
      for (int side = 0; side < 2; ++side)
        for (const std::size_t i : inColumn) {
          auto& mean = means[static_cast<std::size_t>(s - first + side) * column.size() + i];
          mean.stress += stress, mean.equivalent += own.equivalent, ++mean.count;
        }
    }
  }
  return means;
}

}  // namespace

void describePermanentChange(const dynamics::Rolling& rolling, const AlignedVector& unloaded,
                             results::RunResult& result) {
  const auto& model = rolling.model();
  const auto& layer = model.layer;
  const auto& rail = model.blocks[model.rail];
  const auto& flow = rolling.state().plastic;
  const auto column = middleColumn(rail);
  const int first = layer.firstInterval, count = layer.groups * plasticity::lanes;
  auto& change = result.permanent;
  change = {};
  change.lateral = model.surfaces.railY;
  for (const int node : column)
    change.depth.push_back(rail.section.nodes[column.front()][1] - rail.section.nodes[node][1]);
  double deepest = 0, highest = 0;
  for (int s = first; s <= first + count; ++s) {
    change.position.push_back(rail.positions[s]);
    for (const int node : model.surfaces.railLine) {
      const double height = unloaded[rail.index(node, 2, s)];
      change.height.push_back(height);
      deepest = std::min(deepest, height), highest = std::max(highest, height);
    }
  }
  double tension = 0, compression = 0;
  for (const auto& mean : nodeMeans(model, flow, unloaded, column, first, count)) {
    const Stress stress = mean.stress / mean.count;
    change.equivalentStrain.push_back(mean.equivalent / mean.count);
    change.stressAlong.push_back(stress[0]), change.stressAcross.push_back(stress[1]);
    change.stressVertical.push_back(stress[2]), change.vonMises.push_back(vonMises(stress));
    tension = std::max(tension, stress[0]), compression = std::min(compression, stress[0]);
  }
  const auto& flowed = rolling.layerForces().flowed;
  const auto energy = layerEnergy(layer, flow, rolling.layerForces(), unloaded.data());
  result.plasticity = {
      {"largest_equivalent_strain", "1", "equivalent plastic strain at an integration point",
       largestEquivalentStrain(layer, flow)},
      {"deepest_change", "m", "of the running surface, unloaded; down negative", deepest},
      {"highest_change", "m", "of the running surface, unloaded", highest},
      {"largest_residual_tension", "Pa", "along the rail on the plane y = 0, unloaded", tension},
      {"largest_residual_compression", "Pa", "along the rail on the plane y = 0, unloaded", compression},
      {"dissipated", "J", "by plastic flow", energy.dissipated},
      {"stored_by_hardening", "J", "", energy.hardening},
      {"layer_elements", "1", "that may yield", static_cast<double>(layer.elements())},
      {"yielded_share", "1", "of the layer's groups of eight elements",
       static_cast<double>(std::count(flowed.begin(), flowed.end(), 1)) / static_cast<double>(flowed.size())}};
}

}  // namespace squat::simulation
