// A pressed patch rolls once over a block that yields: swept operator, windowed layer and initial stresses against the
// same elements integrated the ordinary way (PlainPlasticity.h), both by the central difference with the same masses,
// steps, damping and loads.
// Theory: they are the same discrete problem, so that only what the program saves may differ: the window of 20 mm, and
// the incompatible modes' amplitudes, which it settles to 1e-5 of the yield strain. Tolerance 0.1 % of the largest
// value of each field, at every instant looked at and after the patch has left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"
#include "plasticity/LayerWork.h"
#include "scenario/Track.h"
#include "verification/PlainPlasticity.h"
#include "verification/Seen.h"

namespace squat::plasticity {
namespace {

using elasticity::steel;

constexpr double size = 0.0026, speed = 200, peak = 1.4e9;  // [m], [m/s], [Pa]
constexpr double halfLength = 0.0065, halfWidth = 0.0050;   // [m] of the patch
constexpr int intervals = 16, layerIntervals = 8, across = 4, down = 4;

elasticity::SweptBlock makeBlock() {
  elasticity::SweptBlock block;
  block.section = elasticity::gridSection(elasticity::evenly(-size * across / 2, size * across / 2, across),
                                          elasticity::evenly(-size * down, 0, down), 0.15);
  block.stations = {0, false, {{intervals, size}}};
  block.material = steel;
  return block;
}

// Pressure of Hertz's shape and a traction of 0.3 of it against x, as forces on the upper nodes.
void load(const elasticity::SweptBlock& block, double patch, const std::function<void(int, int, int, double)>& add) {
  for (int n = 0; n < block.nodes; ++n) {
    const auto& p = block.section.nodes[n];
    if (p[1] < -1e-9) continue;
    for (int s = 0; s <= intervals; ++s) {
      const double x = (block.positions[s] - patch) / halfLength, y = p[0] / halfWidth, inside = 1 - x * x - y * y;
      if (inside <= 0) continue;
      const double force = peak * std::sqrt(inside) * size * size;
      add(n, 0, s, -0.3 * force);
      add(n, 2, s, -force);
    }
  }
}

class RolledOver : public testing::TestWithParam<scenario::Hardening> {};

TEST_P(RolledOver, SameAsElementByElement) {
  std::vector<elasticity::SweptBlock> blocks{makeBlock()};
  const std::size_t total = elasticity::layOut(blocks);
  const auto& block = blocks[0];
  scenario::Rail rail;
  rail.material = steel, rail.yieldStress = 0.8e9, rail.tangentModulus = 21e9;
  rail.hardening = GetParam();
  const auto law = hardeningLaw(rail);
  // Everything but the lowest row may yield, up to an elastic end where the patch rolls out.
  std::vector<int> top;
  for (int i = 0; i <= across; ++i) top.push_back(down * (across + 1) + i);
  const SurfaceLayer layer = makeLayer(block, law, top, 3.2 * size, 0, layerIntervals);
  ASSERT_EQ(layer.quads.size(), 3u * across);

  const auto kernels = elasticity::kernelsFor("");
  const auto layerKernels = layerKernelsFor(kernels.name);
  LayerState state = restState(layer);
  LayerForces forces = layerForces(layer, layerKernels, state);

  // Plain body: nodes numbered station by station.
  const auto location = [&](std::size_t node, std::size_t station) {
    return station * static_cast<std::size_t>(block.nodes) + node;
  };
  std::vector<elasticity::PlainElement> elements;
  std::vector<std::array<int, 2>> elementAt;  // quad, interval
  for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
    for (int s = 0; s < intervals; ++s) {
      elasticity::PlainElement element;
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < 4; ++i) {
          const int node = block.section.quads[q][i];
          element.corners[4 * side + i] = elasticity::nodePosition(block, node, s + side);
          element.node[4 * side + i] = location(node, s + side);
        }
      elements.push_back(element), elementAt.push_back({q, s});
    }
  std::vector<elasticity::PlainElement> plastic, elastic;
  std::vector<std::array<int, 2>> plasticAt;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (layer.indexOfQuad[elementAt[e][0]] >= 0 && elementAt[e][1] < layerIntervals)
      plastic.push_back(elements[e]), plasticAt.push_back(elementAt[e]);
    else
      elastic.push_back(elements[e]);
  const elasticity::PlainLaw plainLaw{law.yieldStress, law.isotropic + law.kinematic, law.kinematic > 0};
  elasticity::PlainBody yielding(plastic, steel, plainLaw), base(elastic, steel, {1e30, 0, false});

  const auto mass = elasticity::lumpedMass(block);
  const double step = 0.25e-6, beta = 0.02e-6;
  std::vector<double> freeMask(block.lines(), 1.0);
  for (int n = 0; n < block.nodes; ++n)
    if (block.section.nodes[n][1] < -size * down + 1e-9)
      for (int c = 0; c < 3; ++c) freeMask[3 * n + c] = 0;
  std::vector<int> lineOfNode(block.nodes);
  for (int n = 0; n < block.nodes; ++n) lineOfNode[n] = n;
  const std::vector<unsigned char> slave(block.nodes, 0);
  AlignedVector inverse(mass.size(), 0.0), acceleration(3 * block.stride, 0.0),
      outer(block.lines() * block.stride, 0.0);
  for (std::size_t i = 0; i < mass.size(); ++i)
    if (mass[i] > 0) inverse[i] = 1 / mass[i];
  const AlignedVector inverseChunks = elasticity::inChunks(block, inverse.data());
  elasticity::BlockStep with;
  with.kernels = &kernels;
  with.inverseMass = inverseChunks.data(), with.freeMask = freeMask.data(), with.lineOfNode = lineOfNode.data();
  with.slave = slave.data(), with.force = outer.data(), with.acceleration = acceleration.data(), with.beta = beta;
  elasticity::KernelScratch scratch(blocks);
  AlignedVector w(total, 0.0), next(total, 0.0), velocity(total, 0.0);

  const auto unknowns = 3 * static_cast<Eigen::Index>(block.nodes) * (intervals + 1);
  Eigen::VectorXd plainW = Eigen::VectorXd::Zero(unknowns), plainV = plainW;
  const double from = 0, to = size * intervals;
  const int steps = static_cast<int>((to - from) / speed / step);
  double largestDisplacement = 0, displacementError = 0, largestFlow = 0;
  for (int k = 0; k < steps; ++k) {
    const double patch = from + speed * step * k;
    const double ramp = std::min(1.0, k / 100.0);
    load(block, patch, [&](int n, int c, int s, double f) { outer[(3 * n + c) * block.stride + s] += ramp * f; });
    returnWindow(layer, layerKernels, w.data(), patch, 0.020, 0, 1, state, forces);
    addPlasticForces(layer, forces, 0, intervals, outer.data(), lineOfNode.data());
    elasticity::advanceSegments({{0, 0, intervals}}, blocks, {with}, step, w.data(), next.data(), velocity.data(),
                                scratch);
    w.swap(next);

    Eigen::VectorXd push = -yielding.innerForce(plainW) - base.innerForce(plainW);
    load(block, patch,
         [&](int n, int c, int s, double f) { push[static_cast<Eigen::Index>(3 * location(n, s)) + c] += ramp * f; });
    for (int s = 0; s <= intervals; ++s)
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 3; ++c) {
          const auto i = static_cast<Eigen::Index>(3 * location(n, s)) + c;
          const double old = plainV[i];
          plainV[i] = (old + step * push[i] * inverse[n * block.stride + s]) * freeMask[3 * n + c];
          plainW[i] += -beta * old + (step + beta) * plainV[i];
        }
    if (k % 50 != 49 && k + 1 != steps) continue;
    for (int s = 0; s <= intervals; ++s)
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 3; ++c) {
          const double plain = plainW[static_cast<Eigen::Index>(3 * location(n, s)) + c];
          largestDisplacement = std::max(largestDisplacement, std::abs(plain));
          displacementError = std::max(displacementError, std::abs(plain - w[block.index(n, c, s)]));
        }
    double flowError = 0;
    for (std::size_t e = 0; e < plastic.size(); ++e) {
      const auto own = elementFlow(layer, state, plasticAt[e][0], plasticAt[e][1]);
      largestFlow = std::max(largestFlow, yielding.equivalent(e));
      flowError = std::max(flowError, std::abs(own.equivalent - yielding.equivalent(e)));
      for (int r = 0; r < 6; ++r)
        flowError = std::max(flowError, std::abs(own.strain[r] - yielding.plasticStrain(e)[r]));
    }
    EXPECT_LT(flowError, 1e-3 * largestFlow + 1e-9) << "step " << k;
    EXPECT_LT(displacementError, 1e-3 * largestDisplacement) << "step " << k;
  }
  // It has yielded well: more than a fifth of the yield strain.
  EXPECT_GT(largestFlow, 0.2 * 0.8e9 / 210e9);
  // The layer's kernels round each to single precision: below 1e-5 instruction sets differ.
  verification::seen("displacement", std::max(0.001, 100 * displacementError / largestDisplacement), "%");
  std::printf("largest plastic strain %.3g, displacement off by %.2g of %.3g mm\n", largestFlow,
              displacementError / largestDisplacement, 1e3 * largestDisplacement);
}

INSTANTIATE_TEST_SUITE_P(Hardening, RolledOver,
                         testing::Values(scenario::Hardening::isotropic, scenario::Hardening::kinematic),
                         [](const auto& kind) {
                           return std::string(kind.param == scenario::Hardening::kinematic ? "kinematic" : "isotropic");
                         });

}  // namespace
}  // namespace squat::plasticity
