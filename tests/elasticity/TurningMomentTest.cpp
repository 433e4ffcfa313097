// The moment of inner forces about displaced positions, as the step of the central difference takes it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "elasticity/SweptKernel.h"
#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"

namespace squat::elasticity {
namespace {

// The same displacement vectors seen from bases that have turned by `angle`, as the step turns them.
AlignedVector turned(const SweptBlock& block, const AlignedVector& u, double angle) {
  AlignedVector v = u;
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s < block.stationCount; ++s) {
      const double a = u[block.index(n, 0, s)], b = u[block.index(n, 1, s)];
      v[block.index(n, 0, s)] = std::cos(angle) * a + std::sin(angle) * b;
      v[block.index(n, 1, s)] = std::cos(angle) * b - std::sin(angle) * a;
    }
  return v;
}

// One step of `block` with masses that are too large to be moved, in `parts` stretches: what gathers in the line.
// `even`: the masses as one number a node.
double momentOfOneStep(const std::vector<SweptBlock>& blocks, const AlignedVector& u, const KernelSet& kernels,
                       int parts, bool even = false) {
  const auto& block = blocks[0];
  const AlignedVector inverseMass(block.size() / 3, 0.0), acceleration(3 * block.stride, 0.0);
  const std::vector<double> freeMask(static_cast<std::size_t>(block.nodes) * 3, 1.0), tiny(block.nodes, 1e-30);
  const std::vector<int> noLine(block.nodes, -1);
  const std::vector<unsigned char> noSlave(block.nodes, 0);
  AlignedVector moment(block.stride, 0.0), velocity(u.size(), 0.0), target(u.size(), 0.0), source = u;
  refreshGhosts(blocks, source.data());
  BlockStep with;
  with.kernels = &kernels;
  with.inverseMass = inverseMass.data(), with.freeMask = freeMask.data(), with.lineOfNode = noLine.data();
  with.slave = noSlave.data(), with.acceleration = acceleration.data(), with.turningMoment = moment.data();
  if (even) with.evenInverse = tiny.data();
  KernelScratch scratch(blocks);
  for (const auto& segments : partition(blocks, {0}, parts))
    advanceSegments(segments, blocks, {with}, 1e-7, source.data(), target.data(), velocity.data(), scratch);
  double sum = 0;
  for (const double value : moment) sum += value;
  return sum;
}

// Virtual work: the stored energy 1/2 u.K u falls by the moment times the angle by which the bases turn under
// displacement vectors that stand still in space. The energy is that of the plain sum of element matrices; the central
// difference over 2e-4 rad errs by 1e-8 of the energy's own size, rounding of forces to single precision by 1e-6 each.
TEST(TurningMoment, IsWhatTheStoredEnergyLosesWhenTheBasesTurn) {
  std::vector<SweptBlock> blocks{ringBlock()};
  const std::size_t size = layOut(blocks);
  const auto k = plainMatrix(blocks, size);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> value(-1e-4, 1e-4);
  AlignedVector u(size, 0.0);
  for (const std::size_t i : unknownsOf(blocks[0])) u[i] = value(generator);
  const auto energy = [&](double angle) {
    const AlignedVector v = turned(blocks[0], u, angle);
    const Eigen::Map<const Eigen::VectorXd> x(v.data(), static_cast<Eigen::Index>(size));
    return 0.5 * x.dot(k * x);
  };
  constexpr double angle = 1e-4;
  const double expected = (energy(-angle) - energy(angle)) / (2 * angle);
  EXPECT_GT(std::abs(expected), 1e-3 * energy(0));
  for (const auto& isa : availableInstructionSets()) {
    const auto kernels = kernelsFor(isa), single = kernelsFor(isa, Precision::singleInside);
    EXPECT_NEAR(momentOfOneStep(blocks, u, kernels, 1), expected, 1e-7 * energy(0)) << isa;
    EXPECT_EQ(momentOfOneStep(blocks, u, kernels, 3), momentOfOneStep(blocks, u, kernels, 1)) << isa;
    EXPECT_NEAR(momentOfOneStep(blocks, u, single, 2), expected, 1e-5 * energy(0)) << isa;
    EXPECT_EQ(momentOfOneStep(blocks, u, kernels, 2, true), momentOfOneStep(blocks, u, kernels, 1)) << isa;
  }
}

}  // namespace
}  // namespace squat::elasticity
