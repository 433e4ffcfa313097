#include "simulation/SurfaceFields.h"

#include <cmath>
#include <map>
#include <numbers>

#include "geometry/RailSection.h"
#include "simulation/VonMises.h"

namespace squat::simulation {

namespace {

constexpr double stressReach = 0.2;  // [m] from the contact
constexpr double cutReach = 0.25;    // [m] beyond the rolled stretch

bool onPlane(const elasticity::SweptBlock& block, int node) {
  const int axis = block.kind == elasticity::SweepKind::alongX ? 0 : 1;
  return std::abs(block.section.nodes[node][axis]) < 1e-9;
}

}  // namespace

SurfaceFields::SurfaceFields(const model::Model& model) : model_(model) {
  mesh_.partNames = {"rail", "sleepers", "wheel rim", "wheel body and axle", "rail cut", "wheel cut"};
  for (const auto& block : model.blocks)
    pointOf_.emplace_back(static_cast<std::size_t>(block.nodes) * (block.intervals + 1), -1);
  addBlock(model.rail, Part::rail, Part::railCut);
  addBlock(model.rim, Part::rim, Part::wheelCut);
  addBlock(model.body, Part::body, Part::wheelCut);
  for (int i = 0; i < model.sleepers; ++i) addBlock(model.firstSleeper + i, Part::sleepers, std::nullopt);
  addSprings();
}

int SurfaceFields::point(int b, int node, int station) {
  const auto& block = model_.blocks[b];
  if (block.closed && station == block.intervals) station = 0;
  int& index = pointOf_[b][static_cast<std::size_t>(node) * (block.intervals + 1) + station];
  if (index < 0) {
    index = static_cast<int>(locations_.size());
    locations_.push_back({b, node, station});
    const Eigen::Vector3d p = elasticity::nodePosition(block, node, station);
    for (int c = 0; c < 3; ++c) mesh_.points.push_back(static_cast<float>(p[c]));
  }
  return index;
}

void SurfaceFields::addFace(Part part, const int (&points)[4]) {
  for (const int p : points) mesh_.quads.push_back(p);
  mesh_.part.push_back(static_cast<std::uint8_t>(part));
}

void SurfaceFields::addBlock(int b, Part part, std::optional<Part> cutPart) {
  const auto& block = model_.blocks[b];
  std::map<std::pair<int, int>, int> edges;  // how many quads share an edge
  for (const auto& quad : block.section.quads)
    for (int i = 0; i < 4; ++i) ++edges[std::minmax(quad[i], quad[(i + 1) % 4])];
  for (const auto& quad : block.section.quads)
    for (int i = 0; i < 4; ++i) {
      const int p = quad[i], q = quad[(i + 1) % 4];
      const bool outer = edges[std::minmax(p, q)] == 1 && !(model_.slave[b][p] && model_.slave[b][q]);
      const bool cut = cutPart && !outer && p < q && onPlane(block, p) && onPlane(block, q);
      if (!outer && !cut) continue;
      for (int s = 0; s < block.intervals; ++s) {
        if (cut && b == model_.rail) {
          const double x = block.positions[s];
          if (x < model_.startX - cutReach || x > model_.scenario.motion.beyond + cutReach) continue;
        }
        addFace(cut ? *cutPart : part, {point(b, p, s), point(b, q, s), point(b, q, s + 1), point(b, p, s + 1)});
      }
    }
  if (block.closed) return;
  for (const int station : {0, block.intervals})
    for (const auto& quad : block.section.quads)
      addFace(part, {point(b, quad[0], station), point(b, quad[1], station), point(b, quad[2], station),
                     point(b, quad[3], station)});
}

// Pads, ballast and suspension as short lines.
void SurfaceFields::addSprings() {
  const auto& d = model_.scenario;
  const double railBase = -geometry::railProfile(d.rail.section).height, sleeperBase = railBase - d.sleeper.height;
  const auto line = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
    for (const double value : {x0, y0, z0, x1, y1, z1}) mesh_.springs.push_back(static_cast<float>(value));
  };
  for (const double x : model_.sleeperPositions) {
    for (const double y : {-0.04, 0.04}) line(x, y, railBase + 0.004, x, y, railBase - 0.004);
    for (const double share : {0.1, 0.37, 0.63, 0.9}) {
      const double y = -d.wheelset.trackCentre + share * d.sleeper.halfLength;
      line(x, y, sleeperBase, x, y, sleeperBase - 0.12);
    }
  }
  const double top = d.wheelset.radius + d.wheelset.journalRadius;
  line(model_.startX, d.wheelset.bearingCentre, top, model_.startX, d.wheelset.bearingCentre, top + 0.3);
}

results::SurfaceSnapshot SurfaceFields::snapshot(const std::string& name, const AlignedVector& u, double time,
                                                 double travel, double rotation, const plasticity::LayerState& flow,
                                                 bool stressEverywhere) const {
  results::SurfaceSnapshot shot;
  shot.name = name, shot.time = time, shot.wheelTravel = travel, shot.wheelRotation = rotation;
  shot.position = model_.startX + travel;
  shot.displacement.resize(3 * locations_.size());
  shot.vonMises.assign(locations_.size(), 0.0f);
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    const auto& [b, node, station] = locations_[i];
    const auto& block = model_.blocks[b];
    const bool turns = block.kind == elasticity::SweepKind::aroundAxis;
    const Eigen::Vector3d local(u[block.index(node, 0, station)], u[block.index(node, 1, station)],
                                u[block.index(node, 2, station)]);
    const Eigen::Vector3d global =
        elasticity::localBasis(block, block.positions[station] - (turns ? rotation : 0)) * local;
    for (int c = 0; c < 3; ++c) shot.displacement[3 * i + c] = static_cast<float>(global[c]);
  }
  std::vector<float> count(locations_.size(), 0.0f);
  const double full = 2 * std::numbers::pi;
  for (int b : {model_.rail, model_.rim, model_.body}) {
    const auto& block = model_.blocks[b];
    const auto hooke = elasticity::elasticityMatrix(block.material);
    for (std::size_t r = 0; r < block.runIntervals.size(); ++r) {
      const double length = block.stations.runs[r].length;
      const auto turn = elasticity::localToMiddle(block, length);
      for (const auto& quad : block.section.quads) {
        const auto corners =
            elasticity::elementCorners(block, static_cast<int>(&quad - block.section.quads.data()), length);
        const Eigen::Matrix<double, 6, 24> stress = hooke * elasticity::centreStrain(corners) * turn;
        for (int s = block.runIntervals[r][0]; s < block.runIntervals[r][1]; ++s) {
          const double at = 0.5 * (block.positions[s] + block.positions[s + 1]);
          const double away = b == model_.rail ? at - shot.position
                                               : std::remainder(at - rotation, full) * model_.scenario.wheelset.radius;
          if (!stressEverywhere && std::abs(away) > stressReach) continue;
          Eigen::Matrix<double, 24, 1> nodal;
          for (int side = 0; side < 2; ++side)
            for (int i = 0; i < 4; ++i)
              for (int c = 0; c < 3; ++c) nodal[12 * side + 3 * i + c] = u[block.index(quad[i], c, s + side)];
          Eigen::Matrix<double, 6, 1> at6 = stress * nodal;
          if (b == model_.rail) {
            const auto plastic =
                elementFlow(model_.layer, flow, static_cast<int>(&quad - block.section.quads.data()), s).strain;
            at6 -= hooke * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(plastic.data());
          }
          const auto value = static_cast<float>(vonMises(at6));
          for (int side = 0; side < 2; ++side)
            for (int i = 0; i < 4; ++i) {
              const int station = block.closed && s + side == block.intervals ? 0 : s + side;
              const int p = pointOf_[b][static_cast<std::size_t>(quad[i]) * (block.intervals + 1) + station];
              if (p >= 0) shot.vonMises[p] += value, count[p] += 1;
            }
        }
      }
    }
  }
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] > 0) shot.vonMises[i] /= count[i];
  addPlasticStrain(flow, shot);
  return shot;
}

void SurfaceFields::addPlasticStrain(const plasticity::LayerState& flow, results::SurfaceSnapshot& shot) const {
  const auto& layer = model_.layer;
  if (layer.empty()) return;
  const int intervals = model_.blocks[model_.rail].intervals, first = layer.firstInterval;
  shot.plasticStrain.assign(locations_.size(), 0.0f);
  std::vector<float> count(locations_.size(), 0.0f);
  for (int interval = first; interval < first + layer.groups * plasticity::lanes; ++interval)
    for (std::size_t q = 0; q < layer.quads.size(); ++q) {
      const auto mean = static_cast<float>(elementFlow(layer, flow, layer.quads[q], interval).equivalent);
      for (int side = 0; side < 2; ++side)
        for (const int node : layer.corners[q]) {
          const int p = pointOf_[model_.rail][static_cast<std::size_t>(node) * (intervals + 1) + interval + side];
          if (p >= 0) shot.plasticStrain[p] += mean, count[p] += 1;
        }
    }
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] > 0) shot.plasticStrain[i] /= count[i];
}

}  // namespace squat::simulation
