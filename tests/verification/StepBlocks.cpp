#include "verification/StepBlocks.h"

#include <cmath>

namespace squat::elasticity {

FreeBlocks::FreeBlocks(std::vector<SweptBlock> blocks, double beta) : blocks_(std::move(blocks)), beta_(beta) {
  const std::size_t size = layOut(blocks_);
  displaced_.assign(size, 0.0), velocity_.assign(size, 0.0), target_.assign(size, 0.0);
  for (const auto& block : blocks_) {
    const auto mass = lumpedMass(block);
    AlignedVector inverse(mass.size(), 0.0);
    for (std::size_t i = 0; i < mass.size(); ++i)
      if (mass[i] > 0) inverse[i] = 1 / mass[i];
    inverseMass_.push_back(std::move(inverse));
    acceleration_.emplace_back(3 * block.stride, 0.0);
    freeMask_.emplace_back(block.lines(), 1.0);
    lineOfNode_.emplace_back(block.nodes, -1);
    slave_.emplace_back(block.nodes, 0);
  }
}

void FreeBlocks::advance(double step, int steps, int parts, const std::string& isa) {
  const auto kernels = kernelsFor(isa);
  std::vector<int> all;
  std::vector<BlockStep> with;
  std::vector<AlignedVector> inverse;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    all.push_back(static_cast<int>(b));
    BlockStep own;
    own.kernels = &kernels;
    inverse.push_back(inChunks(blocks_[b], inverseMass_[b].data()));
    own.inverseMass = inverse.back().data(), own.freeMask = freeMask_[b].data();
    own.lineOfNode = lineOfNode_[b].data(), own.slave = slave_[b].data();
    own.acceleration = acceleration_[b].data(), own.beta = beta_;
    with.push_back(own);
  }
  const auto work = partition(blocks_, all, parts);
  KernelScratch scratch(blocks_);
  for (int k = 0; k < steps; ++k) {
    for (const auto& segments : work)
      advanceSegments(segments, blocks_, with, step, displaced_.data(), target_.data(), velocity_.data(), scratch);
    displaced_.swap(target_);
  }
}

double FreeBlocks::highestEigenvalue(int iterations) {
  AlignedVector u(displaced_.size(), 0.0);
  unsigned seed = 1;
  for (const auto& block : blocks_)
    for (const std::size_t i : unknownsOf(block)) {
      seed = seed * 1664525u + 1013904223u;
      u[i] = static_cast<double>(seed >> 8) / (1u << 24) - 0.5;
    }
  double value = 0;
  for (int k = 0; k < iterations; ++k) {
    const AlignedVector force = applySwept(blocks_, u, "");
    double uMu = 0, uKu = 0, norm = 0;
    AlignedVector next(u.size(), 0.0);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (int n = 0; n < blocks_[b].nodes; ++n)
        for (int c = 0; c < 3; ++c)
          for (int s = 0; s < blocks_[b].stationCount; ++s) {
            const std::size_t i = blocks_[b].index(n, c, s);
            const double inverse = inverseMass_[b][n * blocks_[b].stride + s];
            uMu += u[i] * u[i] / inverse, uKu += u[i] * force[i];
            next[i] = force[i] * inverse, norm += next[i] * next[i];
          }
    value = uKu / uMu;
    for (double& v : next) v /= std::sqrt(norm);
    u = next;
  }
  return value;
}

}  // namespace squat::elasticity
