#include "growth/LayerChange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "elasticity/Hexahedron.h"
#include "geometry/RailSection.h"

namespace squat::growth {

using plasticity::lanes;
using plasticity::points;
namespace row = plasticity::row;

std::vector<double> elementStrain(const plasticity::SurfaceLayer& layer, const plasticity::LayerState& state) {
  std::vector<double> strain(layer.elements(), 0.0);
  const std::size_t stride = static_cast<std::size_t>(layer.rows()) * lanes;
  for (std::size_t g = 0; g < layer.size(); ++g)
    for (int p = 0; p < points; ++p)
      for (int lane = 0; lane < lanes; ++lane)
        strain[g * lanes + lane] +=
            state.values[g * layer.groupState() + p * stride + row::equivalent * lanes + lane] / points;
  return strain;
}

std::vector<double> elementDepth(const plasticity::SurfaceLayer& layer, const elasticity::SweptBlock& rail,
                                 scenario::RailSection section) {
  std::vector<double> depth(layer.elements(), 0.0);
  for (int along = 0; along < layer.groups; ++along)
    for (std::size_t quad = 0; quad < layer.quads.size(); ++quad) {
      double below = 0;
      for (const int node : layer.corners[quad]) {
        const auto& p = rail.section.nodes[node];
        below += (geometry::crownHeight(section, p[0]) - p[1]) / 4;
      }
      std::fill_n(depth.begin() + static_cast<std::ptrdiff_t>(layer.group(along, quad) * lanes), lanes, below);
    }
  return depth;
}

void hardenOn(const plasticity::SurfaceLayer& layer, const plasticity::LayerState& before, double more,
              plasticity::LayerState& state) {
  if (more <= 0) return;
  const auto& law = layer.law;
  const int rows = layer.rows();
  const double ceiling = std::sqrt(2.0 / 3) * law.saturation / (2 * law.shearModulus);
  for (std::size_t first = 0; first < state.values.size(); first += static_cast<std::size_t>(rows) * lanes)
    for (int lane = 0; lane < lanes; ++lane) {
      double* now = &state.values[first + static_cast<std::size_t>(lane)];
      const double* then = &before.values[first + static_cast<std::size_t>(lane)];
      const double strain = more * (now[row::equivalent * lanes] - then[row::equivalent * lanes]);
      if (strain == 0) continue;
      now[row::equivalent * lanes] += strain;
      if (!law.recovers) continue;
      double& growth = now[row::growth * lanes];
      growth = ceiling - (ceiling - growth) * std::exp(-law.rate * strain);
    }
}

namespace {

constexpr double gauss = std::numbers::inv_sqrt3;

// Section quads as bricks of unit length, whose own coordinates serve to find a place in them.
std::vector<elasticity::Corners> bricksOf(const plasticity::SurfaceLayer& layer, const elasticity::SweptBlock& rail) {
  std::vector<elasticity::Corners> bricks;
  for (const auto& corners : layer.corners) {
    auto& brick = bricks.emplace_back();
    for (int k = 0; k < 8; ++k) {
      const auto& p = rail.section.nodes[corners[k % 4]];
      brick[k] = {k < 4 ? 0.0 : 1.0, p[0], p[1]};
    }
  }
  return bricks;
}

// Where integration point p of a brick stands, `lower` by so much; in the plane half way along.
Eigen::Vector3d placeOf(const elasticity::Corners& brick, int p, double lower) {
  const double xi = (p % 4 == 1 || p % 4 == 2 ? gauss : -gauss), eta = (p % 4 >= 2 ? gauss : -gauss);
  const auto shape = elasticity::hexahedronShape(xi, eta, 0);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (int k = 0; k < 8; ++k) at += shape[k] * brick[k];
  at[2] -= lower;
  return at;
}

struct Found {
  std::size_t quad = 0;
  std::array<double, 4> weight{};  // of its points 0-3 and, in the other half along the rail, 4-7
};
std::optional<Found> found(const std::vector<elasticity::Corners>& bricks, const Eigen::Vector3d& place) {
  for (std::size_t quad = 0; quad < bricks.size(); ++quad) {
    const auto own = elasticity::referenceCoordinates(bricks[quad], place);
    if (!(std::abs(own[0]) <= 1 + 1e-6 && std::abs(own[1]) <= 1 + 1e-6)) continue;
    Found one{quad, {}};
    const auto shape = elasticity::hexahedronShape(own[0] / gauss, own[1] / gauss, -1);
    std::copy_n(shape.begin(), 4, one.weight.begin());
    return one;
  }
  return {};
}

}  // namespace

void grindLayer(const plasticity::SurfaceLayer& layer, const elasticity::SweptBlock& rail, double depth,
                plasticity::LayerState& state) {
  const auto source = state.values;
  const auto bricks = bricksOf(layer, rail);
  const std::size_t stride = static_cast<std::size_t>(layer.rows()) * lanes;
  for (std::size_t quad = 0; quad < bricks.size(); ++quad)
    for (int p = 0; p < points; ++p) {
      const auto from = found(bricks, placeOf(bricks[quad], p, depth));
      for (int along = 0; along < layer.groups; ++along) {
        double* to = &state.values[layer.group(along, quad) * layer.groupState() + p * stride];
        std::fill_n(to, stride, 0.0);
        if (!from) continue;
        const double* values = &source[layer.group(along, from->quad) * layer.groupState()];
        for (int k = 0; k < 4; ++k)
          for (std::size_t i = 0; i < stride; ++i) to[i] += from->weight[k] * values[(k + p / 4 * 4) * stride + i];
      }
    }
}

}  // namespace squat::growth
