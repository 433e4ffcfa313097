#include "plasticity/SurfaceLayer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/ElementaryFunctions.h"
#include "plasticity/LayerKernel.h"
#include "scenario/Track.h"

namespace squat::plasticity {

namespace {

double distanceTo(const geometry::Point2& p, const geometry::Point2& a, const geometry::Point2& b) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  const double t = std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y), 0.0, 1.0);
  return elementary::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

std::vector<int> quadsWithin(const elasticity::SweptBlock& rail, const std::vector<int>& surface, double depth) {
  const auto& nodes = rail.section.nodes;
  std::vector<int> found;
  for (int q = 0; q < static_cast<int>(rail.section.quads.size()); ++q) {
    geometry::Point2 centre{0, 0};
    for (const int n : rail.section.quads[q]) centre[0] += nodes[n][0] / 4, centre[1] += nodes[n][1] / 4;
    double nearest = depth;
    for (std::size_t i = 0; i + 1 < surface.size(); ++i)
      nearest = std::min(nearest, distanceTo(centre, nodes[surface[i]], nodes[surface[i + 1]]));
    if (nearest < depth) found.push_back(q);
  }
  return found;
}

// Deviatoric rows xx, yy, 2xy, 2yz, 2zx of a strain column xx, yy, zz, 2xy, 2yz, 2zx.
void deviatoric(const Eigen::Matrix<double, 6, 1>& e, double* out) {
  const double mean = (e[0] + e[1] + e[2]) / 3;
  out[0] = e[0] - mean, out[1] = e[1] - mean, out[2] = e[3], out[3] = e[4], out[4] = e[5];
}

std::vector<double> coefficientsOf(const elasticity::Corners& corners, const scenario::Material& material) {
  const auto element = elasticity::hexahedronPoints(corners, material);
  const double twoMu = material.young / (1 + material.poisson);
  std::vector<double> c(coefficient::count, 0.0);
  double& steepest = c[coefficient::steepest];
  for (int p = 0; p < 8; ++p) {
    for (int j = 0; j < 24; ++j) deviatoric(element.strain[p].col(j), &c[coefficient::strain + (p * 24 + j) * 5]);
    for (int i = 0; i < 9; ++i) deviatoric(element.inner[p].col(i), &c[coefficient::inner + (p * 9 + i) * 5]);
    steepest = std::max(steepest, element.inner[p].cwiseAbs().maxCoeff());
    // The kernel multiplies with work rows (2 e_xx + e_yy, e_xx + 2 e_yy, e_xy / 2 ...): amplitudes are made by the
    // deviatoric inner strains, a_i = sum Kaa^-1_ij 2 mu weight dev(inner_j) : eps_p. The rows of `amplitude` belong to
    // stresses xx, yy, zz, xy, yz, zx; of a traceless stress 2 mu eps_p only its deviatoric part works.
    for (int i = 0; i < 9; ++i) {
      const auto row = element.amplitude[p].row(i);
      const double mean = (row[0] + row[1] + row[2]) / 3;
      const double dual[5] = {row[0] - mean, row[1] - mean, row[3], row[4], row[5]};
      for (int r = 0; r < 5; ++r) c[coefficient::amplitude + (p * 5 + r) * 9 + i] = twoMu * dual[r];
    }
    c[coefficient::weight + p] = twoMu * element.weight[p];
  }
  return c;
}

using Shifts = std::array<elasticity::Corners, lanes>;

// Shifts of the corners of a group's elements, nothing where all of them keep their place.
std::optional<Shifts> shiftsOf(const SurfaceLayer& layer, const NodeShift& moved, int along, std::size_t quad) {
  if (!moved) return {};
  Shifts shifts;
  bool any = false;
  for (int lane = 0; lane < lanes; ++lane)
    for (int side = 0; side < 2; ++side)
      for (int k = 0; k < 4; ++k) {
        auto& by = shifts[lane][4 * side + k];
        by = moved(layer.corners[quad][k], layer.station(along) + lane + side);
        any = any || by.squaredNorm() > 0;
      }
  return any ? std::optional(shifts) : std::nullopt;
}

AlignedVector laneByLane(const elasticity::Corners& corners, const Shifts& shifts, const scenario::Material& material) {
  AlignedVector all(static_cast<std::size_t>(coefficient::count) * lanes, 0.0);
  for (int lane = 0; lane < lanes; ++lane) {
    auto own = corners;
    for (int k = 0; k < 8; ++k) own[k] += shifts[lane][k];
    const auto c = coefficientsOf(own, material);
    for (std::size_t k = 0; k < c.size(); ++k) all[lanes * k + lane] = c[k];
  }
  return all;
}

}  // namespace

HardeningLaw hardeningLaw(const scenario::Rail& rail) {
  const double e = rail.material.young;
  HardeningLaw law;
  law.shearModulus = e / (2 * (1 + rail.material.poisson));
  law.yieldStress = rail.yieldStress;
  if (rail.hardening == scenario::Hardening::chaboche) {
    law.recovers = true;
    law.backstresses = rail.backstresses, law.exponent = rail.recoveryExponent;
    law.saturation = rail.isotropicSaturation, law.rate = rail.isotropicRate;
    return law;
  }
  const double tangent = std::clamp(rail.tangentModulus, 0.0, 0.999 * e);  // the case's checks refuse more
  (rail.hardening == scenario::Hardening::kinematic ? law.kinematic : law.isotropic) = e * tangent / (e - tangent);
  return law;
}

SurfaceLayer makeLayer(const elasticity::SweptBlock& rail, const HardeningLaw& law, const std::vector<int>& surface,
                       double depth, int first, int count, const NodeShift& moved) {
  SurfaceLayer layer;
  layer.law = law;
  layer.quads = quadsWithin(rail, surface, depth);
  layer.blockOffset = rail.offset, layer.chunkSize = rail.chunkSize(), layer.stride = rail.stride;
  layer.firstInterval = first / lanes * lanes;
  layer.groups = (std::min(first + count, rail.intervals) - layer.firstInterval + lanes - 1) / lanes;
  layer.indexOfQuad.assign(rail.section.quads.size(), -1);
  for (const int q : layer.quads) {
    layer.indexOfQuad[q] = static_cast<int>(layer.corners.size());
    layer.corners.push_back(rail.section.quads[q]);
  }
  for (int along = 0; along < layer.groups; ++along)
    layer.extent.push_back({rail.positions[layer.station(along)], rail.positions[layer.station(along) + lanes]});

  std::vector<std::vector<int>> ofRun(rail.runIntervals.size(), std::vector<int>(layer.quads.size(), -1));
  layer.own.assign(layer.size(), 0);
  for (int along = 0; along < layer.groups; ++along) {
    const int station = layer.station(along), run = rail.runOf(station);
    for (std::size_t i = 0; i < layer.quads.size(); ++i) {
      const auto corners = elasticity::elementCorners(rail, layer.quads[i], rail.stations.runs[run].length);
      const auto shifts = shiftsOf(layer, moved, along, i);
      int& common = ofRun[run][i];
      if (shifts) {
        layer.own[layer.group(along, i)] = 1;
        layer.shapes.push_back(laneByLane(corners, *shifts, rail.material));
      } else if (common < 0) {
        const auto c = coefficientsOf(corners, rail.material);
        common = static_cast<int>(layer.shapes.size());
        layer.shapes.emplace_back(c.begin(), c.end());
      }
      layer.shapeOf.push_back(shifts ? static_cast<int>(layer.shapes.size()) - 1 : common);
    }
  }
  return layer;
}

LayerState restState(const SurfaceLayer& layer) { return {AlignedVector(layer.size() * layer.groupState(), 0.0)}; }

std::vector<int> layerNodes(const SurfaceLayer& layer) {
  std::set<int> nodes;
  for (const auto& quad : layer.corners) nodes.insert(quad.begin(), quad.end());
  return {nodes.begin(), nodes.end()};
}

}  // namespace squat::plasticity
