// Plastic flow moves steel about and makes none.
// Theory: plastic strain has no trace, and the mean of the residual stress over a body without loads is zero, so that
// the volume of the whole rail stays. Pads pull on its foot a little as it settles; 1 %, the bound asked for, of the
// volume that is moved at the running surface.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "elasticity/Hexahedron.h"
#include "growth/SmallRail.h"
#include "plasticity/LayerKernel.h"
#include "statics/UnloadedShape.h"

namespace squat::growth {
namespace {

// [m3] of a change over the whole grid.
double volumeOf(const SurfaceGrid& grid, const Field& change) {
  double volume = 0;
  for (std::size_t s = 0; s + 1 < grid.x.size(); ++s)
    for (std::size_t line = 0; line + 1 < grid.y.size(); ++line)
      volume += 0.25 * (grid.x[s + 1] - grid.x[s]) * (grid.y[line + 1] - grid.y[line]) *
                (change[grid.index(s, line)] + change[grid.index(s, line + 1)] + change[grid.index(s + 1, line)] +
                 change[grid.index(s + 1, line + 1)]);
  return volume;
}

double volumeChange(const elasticity::SweptBlock& rail, const AlignedVector& u) {
  double volume = 0;
  for (std::size_t q = 0; q < rail.section.quads.size(); ++q)
    for (int s = 0; s < rail.intervals; ++s) {
      elasticity::Corners corners;
      std::array<Eigen::Vector3d, 8> moved;
      for (int k = 0; k < 8; ++k) {
        const int node = rail.section.quads[q][k % 4], station = s + k / 4;
        corners[k] = elasticity::nodePosition(rail, node, station);
        moved[k] = {u[rail.index(node, 0, station)], u[rail.index(node, 1, station)], u[rail.index(node, 2, station)]};
      }
      constexpr double at = 0.57735026918962576;
      for (int p = 0; p < 8; ++p) {
        double determinant = 0;
        const auto gradients =
            elasticity::shapeGradients(corners, p & 1 ? at : -at, p & 2 ? at : -at, p & 4 ? at : -at, determinant);
        for (int k = 0; k < 8; ++k) volume += determinant * gradients.col(k).dot(moved[k]);
      }
    }
  return volume;
}

TEST(FlowVolume, FlowConservesTheVolumeOfTheRail) {
  const auto& model = tests::smallModel();
  const auto& layer = model.layer;
  auto state = plasticity::restState(layer);
  std::mt19937 random(5);
  const std::size_t stride = static_cast<std::size_t>(layer.rows()) * plasticity::lanes;
  // Steel pressed down in one group and its neighbours, as by a wheel, with noise.
  for (std::size_t g = layer.size() / 2; g < layer.size() / 2 + 6; ++g)
    for (int p = 0; p < plasticity::points; ++p)
      for (int r = 0; r < 5; ++r)
        for (int lane = 0; lane < plasticity::lanes; ++lane)
          state.values[g * layer.groupState() + p * stride + r * plasticity::lanes + lane] =
              1e-3 * ((r < 2 ? 0.5 : 0.0) + 1e-3 * static_cast<double>(random() % 1000));
  const auto kernels = elasticity::kernelsFor("");
  const auto forces = plasticity::layerForces(layer, plasticity::layerKernelsFor(kernels.name), state);
  ThreadTeam team(1);
  Monitor silent;
  statics::UnloadedShapes shapes(model, kernels, team);
  ASSERT_TRUE(shapes.prepare(silent));
  statics::UnloadedShape shape;
  shapes.follow(forces, 1e-7, shape, silent);

  const auto grid = tests::smallGrid();
  Field moved = risenNodes(grid, model, shape.displacement);
  for (double& value : moved) value = std::abs(value);
  const double atSurface = volumeOf(grid, moved);
  ASSERT_GT(atSurface, 1e-12);
  EXPECT_LT(std::abs(volumeChange(model.blocks[model.rail], shape.displacement)), 0.01 * atSurface);

  // In two parts it comes to the same: what is new is added to what stands. Two solutions to 1e-7 of the forces.
  auto half = state;
  for (double& value : half.values) value *= 0.5;
  statics::UnloadedShapes inParts(model, kernels, team);
  ASSERT_TRUE(inParts.prepare(silent));
  statics::UnloadedShape sum;
  inParts.follow(plasticity::layerForces(layer, plasticity::layerKernelsFor(kernels.name), half), 1e-7, sum, silent);
  inParts.follow(forces, 1e-7, sum, silent);
  const Field whole = risenNodes(grid, model, shape.displacement), twice = risenNodes(grid, model, sum.displacement);
  const double highest = *std::max_element(moved.begin(), moved.end());
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(twice[i], whole[i], 1e-3 * highest);
}

}  // namespace
}  // namespace squat::growth
