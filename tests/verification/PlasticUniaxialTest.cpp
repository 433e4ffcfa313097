// A bar pulled, unloaded, pressed and pulled again beyond yield, every element of it at once.
// Theory: bilinear steel under uniaxial stress s (J. C. Simo, T. J. R. Hughes, Computational Inelasticity, 1998, 1.2
// and 1.4), plastic modulus H = E Et / (E - Et):
//   isotropic: yields where |s| > s_y + H p;         kinematic: yields where |s - H e_p| > s_y;
//   d e_p = d s / H,  e = s / E + e_p,  across: -nu s / E - e_p / 2.
// The bar takes the closed form's strains; its stress and plastic strain must be the closed form's. Tolerance:
// round-off of sums over 24 unknowns times E / s, 1e-11.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "elasticity/IrregularElements.h"
#include "elasticity/SweptKernel.h"
#include "elasticity/SweptSamples.h"
#include "plasticity/LayerWork.h"
#include "scenario/Track.h"

namespace squat::plasticity {
namespace {

using elasticity::steel;

constexpr double yieldStress = 0.8e9, tangent = 21e9;

struct Bar {
  std::vector<elasticity::SweptBlock> blocks;
  SurfaceLayer layer;
  elasticity::IrregularElements irregular;
  std::size_t size = 0;
};

// A bar of 2 x 3 skewed quads and 8 intervals; `moved`: one of its inner nodes stands elsewhere.
Bar makeBar(scenario::Hardening hardening, bool moved) {
  Bar bar;
  bar.blocks.resize(1);
  auto& block = bar.blocks[0];
  block.section = elasticity::gridSection(elasticity::evenly(0, 0.01, 2), elasticity::evenly(0, 0.012, 3), 0.2);
  block.stations = {0, false, {{8, 0.004}}};
  block.material = steel;
  bar.size = elasticity::layOut(bar.blocks);
  scenario::Rail rail;
  rail.material = steel, rail.yieldStress = yieldStress, rail.tangentModulus = tangent;
  rail.hardening = hardening;
  const elasticity::NodeShift shift = [](int node, int station) {
    return node == 4 && station == 3 ? Eigen::Vector3d(0.0005, 0.0004, -0.0006) : Eigen::Vector3d(0, 0, 0);
  };
  bar.layer = makeLayer(block, hardeningLaw(rail), {9, 11}, 0.1, 0, 8, moved ? shift : elasticity::NodeShift());
  if (moved) bar.irregular = elasticity::irregularElements(block, shift);
  return bar;
}

struct Uniaxial {
  bool kinematic;
  double plastic = 0, equivalent = 0;
  // Goes to the stress s.
  void load(double s) {
    const double hardening = steel.young * tangent / (steel.young - tangent);
    const double centre = kinematic ? hardening * plastic : 0;
    const double limit = yieldStress + (kinematic ? 0 : hardening * equivalent);
    if (std::abs(s - centre) <= limit) return;
    const double by = (std::abs(s - centre) - limit) / hardening;
    plastic += s > centre ? by : -by, equivalent += by;
  }
};

class UniaxialPlasticity : public testing::TestWithParam<std::tuple<scenario::Hardening, bool, std::string>> {};

TEST_P(UniaxialPlasticity, LoadUnloadReload) {
  const auto& [hardening, moved, isa] = GetParam();
  const Bar bar = makeBar(hardening, moved);
  const auto& block = bar.blocks[0];
  ASSERT_EQ(bar.layer.elements(), block.elements());
  const auto kernels = layerKernelsFor(isa);
  LayerState state = restState(bar.layer);
  LayerForces forces = layerForces(bar.layer, kernels, state);
  Uniaxial law{hardening == scenario::Hardening::kinematic};
  const double area = 0.01 * 0.012, volume = area * 8 * 0.004;
  std::vector<int> everyNode(block.nodes);
  std::iota(everyNode.begin(), everyNode.end(), 0);
  double before = 0;
  for (const double goal : {1.0e9, 0.1e9, 0.95e9, -1.0e9, 0.0, 1.25e9, 0.0})
    for (int k = 1; k <= 5; ++k) {
      const double s = before + (goal - before) * k / 5;
      law.load(s);
      const double along = s / steel.young + law.plastic, lateral = -steel.poisson * s / steel.young - law.plastic / 2;
      AlignedVector u(bar.size, 0.0);
      // A moved node takes the place it stands at.
      elasticity::setField(
          block,
          [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(along * p[0], lateral * p[1], lateral * p[2]); }, u);
      if (moved) {
        u[block.index(4, 0, 3)] += along * 0.0005;
        u[block.index(4, 1, 3)] += lateral * 0.0004;
        u[block.index(4, 2, 3)] += lateral * -0.0006;
      }
      returnWindow(bar.layer, kernels, u.data(), 0.016, 1, 0, 1, state, forces);
      for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
        for (int i = 0; i < 8; ++i) {
          const auto flow = elementFlow(bar.layer, state, q, i);
          EXPECT_NEAR(flow.equivalent, law.equivalent, 1e-14);
          const double wanted[6] = {law.plastic, -law.plastic / 2, -law.plastic / 2, 0, 0, 0};
          for (int r = 0; r < 6; ++r) EXPECT_NEAR(flow.strain[r], wanted[r], 1e-14);
        }
      // Elastic force less that of the plastic strain: s times area at the ends, nothing within.
      AlignedVector force = elasticity::applySwept(bar.blocks, u, isa), plastic(block.lines() * block.stride, 0.0);
      elasticity::addIrregularStiffness(bar.irregular, u.data(), force.data());
      addPlasticForces(bar.layer, forces, 0, 8, plastic.data(), everyNode.data());
      const LayerEnergy energy = layerEnergy(bar.layer, state, forces, u.data());
      double elastic = energy.elastic;
      for (std::size_t i = 0; i < bar.size; ++i) elastic += 0.5 * u[i] * force[i];
      EXPECT_NEAR(elastic, 0.5 * s * s / steel.young * volume,
                  1e-11 * yieldStress * yieldStress / steel.young * volume);
      EXPECT_NEAR(energy.dissipated, yieldStress * law.equivalent * volume, 1e-12 * yieldStress * volume);
      for (int station = 0; station < 8; ++station) {  // the last station is another segment's
        double sum = 0, maximum = 0;
        for (int n = 0; n < block.nodes; ++n)
          for (int c = 0; c < 3; ++c) {
            const double rest = force[block.index(n, c, station)] - plastic[(3 * n + c) * block.stride + station];
            if (c == 0) sum += rest;
            maximum = std::max(maximum, std::abs(rest));
          }
        EXPECT_NEAR(sum, station == 0 ? -s * area : 0.0, 1e-11 * steel.young * area * 0.01);
        if (station == 0) continue;
        EXPECT_LT(maximum, 1e-11 * steel.young * area * 0.01) << "station " << station;
      }
      if (k == 5) before = goal;
    }
  EXPECT_GT(law.equivalent, 0.01);
}

std::vector<std::tuple<scenario::Hardening, bool, std::string>> everyKind() {
  std::vector<std::tuple<scenario::Hardening, bool, std::string>> kinds;
  for (const auto& isa : elasticity::availableInstructionSets())
    for (const bool moved : {false, true})
      for (const auto hardening : {scenario::Hardening::isotropic, scenario::Hardening::kinematic})
        kinds.push_back({hardening, moved, isa});
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, UniaxialPlasticity, testing::ValuesIn(everyKind()), [](const auto& kind) {
  return std::string(std::get<0>(kind.param) == scenario::Hardening::kinematic ? "kinematic" : "isotropic") +
         (std::get<1>(kind.param) ? "Moved_" : "_") + std::get<2>(kind.param);
});

}  // namespace
}  // namespace squat::plasticity
