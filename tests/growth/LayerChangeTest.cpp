// What blocks of passages and the grinding train do to the layer that yields.
#include "growth/LayerChange.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/RailSection.h"
#include "growth/SmallRail.h"

namespace squat::growth {
namespace {

namespace row = plasticity::row;
using plasticity::lanes;

plasticity::SurfaceLayer chabocheLayer() {
  auto layer = tests::smallModel().layer;
  layer.law.recovers = true;
  layer.law.backstresses = {{{100e9, 1000}, {10e9, 100}, {5e9, 0}}};
  layer.law.saturation = 90e6, layer.law.rate = 20;
  return layer;
}

// A point's rows in the first lane of the first group.
double* pointOf(plasticity::LayerState& state) { return state.values.data(); }

TEST(LayerChange, HardeningGoesOnInTheSameDirection) {
  const auto layer = chabocheLayer();
  const double twoMu = 2 * layer.law.shearModulus;
  auto before = plasticity::restState(layer), after = before;
  double* now = pointOf(after);
  now[row::flow * lanes] = 1e-4;
  now[row::equivalent * lanes] = 2e-4;
  now[(row::backstress + 2) * lanes] = 1e-6;  // first back-stress, 2xy
  now[row::growth * lanes] = std::sqrt(2.0 / 3) * 90e6 / twoMu * (1 - std::exp(-20 * 2e-4));
  hardenOn(layer, before, 50, after);
  EXPECT_EQ(now[row::flow * lanes], 1e-4);  // the strain itself stays
  EXPECT_NEAR(now[row::equivalent * lanes], 51 * 2e-4, 1e-15);
  EXPECT_EQ(now[(row::backstress + 2) * lanes], 1e-6);  // and so do back-stresses
  // Voce: Q (1 - exp(-b p)) at the strain that has been reached.
  EXPECT_NEAR(now[row::growth * lanes], std::sqrt(2.0 / 3) * 90e6 / twoMu * (1 - std::exp(-20 * 51 * 2e-4)), 1e-15);
}

TEST(LayerChange, NothingHappensWhereNothingFlowed) {
  const auto layer = chabocheLayer();
  auto state = plasticity::restState(layer);
  state.values.assign(state.values.size(), 3e-4);
  const auto before = state;
  hardenOn(layer, before, 1000, state);
  EXPECT_EQ(state.values, before.values);
}

// A field that is linear in depth is interpolated exactly: what comes up is the field so much deeper. Points whose
// source lies in the same quad or the one below see it; what lies below the layer is new steel.
TEST(LayerChange, GrindingBringsUpWhatIsDeeper) {
  const auto& model = tests::smallModel();
  const auto& layer = model.layer;
  const auto& rail = model.blocks[model.rail];
  const double depth = 0.4e-3;
  auto state = plasticity::restState(layer);
  const double gauss = 1 / std::sqrt(3.0);
  const auto heightOf = [&](std::size_t quad, int p) {
    const double xi = (p % 4 == 1 || p % 4 == 2 ? gauss : -gauss), eta = (p % 4 >= 2 ? gauss : -gauss);
    const double weight[4] = {(1 - xi) * (1 - eta) / 4, (1 + xi) * (1 - eta) / 4, (1 + xi) * (1 + eta) / 4,
                              (1 - xi) * (1 + eta) / 4};
    double z = 0;
    for (int k = 0; k < 4; ++k) z += weight[k] * rail.section.nodes[layer.corners[quad][k]][1];
    return z;
  };
  const auto field = [](double z) { return 0.01 + 2 * z; };
  const std::size_t stride = static_cast<std::size_t>(layer.rows()) * lanes;
  const auto at = [&](std::size_t quad, int p) -> double& {
    return state.values[layer.group(1, quad) * layer.groupState() + p * stride + row::equivalent * lanes + 3];
  };
  for (std::size_t quad = 0; quad < layer.quads.size(); ++quad)
    for (int p = 0; p < plasticity::points; ++p) at(quad, p) = field(heightOf(quad, p));
  grindLayer(layer, rail, depth, state);
  int risen = 0, fresh = 0;
  for (std::size_t quad = 0; quad < layer.quads.size(); ++quad)
    for (int p = 0; p < plasticity::points; ++p) {
      if (at(quad, p) == 0) {
        ++fresh;
        continue;
      }
      ++risen;
      EXPECT_NEAR(at(quad, p), field(heightOf(quad, p) - depth), 1e-9);
    }
  EXPECT_GT(risen, 4 * fresh);
}

TEST(LayerChange, StrainAndDepthOfElements) {
  const auto& model = tests::smallModel();
  const auto& layer = model.layer;
  auto state = plasticity::restState(layer);
  // Element 5 of the third group: the mean over its eight points.
  const std::size_t stride = static_cast<std::size_t>(layer.rows()) * lanes;
  for (int p = 0; p < plasticity::points; ++p)
    state.values[2 * layer.groupState() + p * stride + row::equivalent * lanes + 5] = p;
  const auto strain = elementStrain(layer, state);
  EXPECT_DOUBLE_EQ(strain[2 * lanes + 5], 3.5);
  EXPECT_EQ(strain[2 * lanes + 4], 0);
  const auto depth = elementDepth(layer, model.blocks[model.rail], model.scenario.rail.section);
  const auto [least, most] = std::minmax_element(depth.begin(), depth.end());
  EXPECT_GT(*least, 0);
  EXPECT_LT(*most, model.scenario.rail.plasticDepth + 1e-3);  // the crown falls towards its sides
}

}  // namespace
}  // namespace squat::growth
