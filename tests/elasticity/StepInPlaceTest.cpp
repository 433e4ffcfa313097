// A step that overwrites the displacements it starts from, against one that has room for both: the same bits, however
// the stations are shared, in whatever order the shares are worked off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "elasticity/SweptKernel.h"
#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"

namespace squat::elasticity {
namespace {

// Cuts between threads and ends of runs lie within and at the ends of chunks of 32 stations. Short waves are slowed in
// part of each.
std::vector<SweptBlock> ringAndBar() {
  SweptBlock ring = ringBlock(), bar;
  const double full = 2 * std::acos(-1.0), fine = 0.02;
  ring.stations = {0.3, true, {{72, fine}, {24, (full - 72 * fine) / 24}}};
  bar.name = "bar", bar.kind = SweepKind::alongX;
  bar.section = gridSection({-0.03, -0.01, 0.005, 0.03}, {0, 0.02, 0.035}, 0.25);
  bar.stations = {-0.2, false, {{16, 0.0013}, {8, 0.0026}, {40, 0.005}}};
  bar.material = steel;
  ring.clusters = {{0, 1, 4, 5}, {2, 3, 6, 7, 11}}, ring.shortLength = 0.03;
  bar.clusters = {{0, 1, 2, 3, 4, 5, 6, 7}, {8}}, bar.shortLength = 0.003;
  return {ring, bar};
}

struct Stepped {
  AlignedVector displaced, velocity;
  bool operator==(const Stepped&) const = default;
};

class Stepper {
 public:
  // The first `inSingle` of ring and bar are computed in single precision.
  Stepper(const std::string& isa, std::size_t inSingle)
      : blocks_(ringAndBar()),
        size_(layOut(blocks_)),
        kernels_(kernelsFor(isa)),
        single_(kernelsFor(isa, Precision::singleInside)) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> value(-1e-4, 1e-4);
    start_.displaced.assign(size_, 0.0), start_.velocity.assign(size_, 0.0);
    for (auto& block : blocks_)
      for (const std::size_t i : unknownsOf(block))
        start_.displaced[i] = value(generator), start_.velocity[i] = 1e3 * value(generator);
    refreshGhosts(blocks_, start_.displaced.data());
    for (const auto& block : blocks_) {
      inverseMass_.emplace_back(block.size() / 3, 30.0);
      acceleration_.emplace_back(3 * block.stride, -9.81);
      freeMask_.emplace_back(static_cast<std::size_t>(block.nodes) * 3, 1.0);
      noLine_.emplace_back(block.nodes, -1);
      noSlave_.emplace_back(block.nodes, 0);
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      BlockStep with;
      with.kernels = b < inSingle ? &single_ : &kernels_;
      with.inverseMass = inverseMass_[b].data(), with.freeMask = freeMask_[b].data();
      with.lineOfNode = noLine_[b].data(), with.slave = noSlave_[b].data();
      with.acceleration = acceleration_[b].data(), with.beta = 1e-8;
      if (b == 0) with.cosine = std::cos(1e-4), with.sine = std::sin(1e-4);
      steps_.push_back(with);
    }
  }

  Stepped withRoom() const {
    Stepped now = start_;
    AlignedVector target = now.displaced;
    KernelScratch scratch(blocks_);
    for (const auto& segments : partition(blocks_, {0, 1}, 1))
      advanceSegments(segments, blocks_, steps_, 1e-7, now.displaced.data(), target.data(), now.velocity.data(),
                      scratch);
    now.displaced = target;
    return now;
  }

  Stepped inPlace(int parts, bool backwards) const {
    Stepped now = start_;
    KernelScratch scratch(blocks_);
    auto work = partition(blocks_, {0, 1}, parts);
    if (backwards) std::reverse(work.begin(), work.end());
    std::vector<std::vector<SegmentEnds>> ends;
    for (const auto& segments : work) {
      ends.push_back(segmentEnds(segments, blocks_));
      for (std::size_t i = 0; i < segments.size(); ++i)
        readEnd(segments[i], blocks_, steps_, now.displaced.data(), scratch, ends.back()[i]);
    }
    for (std::size_t i = 0; i < work.size(); ++i)
      advanceSegments(work[i], blocks_, steps_, 1e-7, now.displaced.data(), now.displaced.data(), now.velocity.data(),
                      scratch, &ends[i]);
    return now;
  }

 private:
  std::vector<SweptBlock> blocks_;
  std::size_t size_;
  KernelSet kernels_, single_;
  Stepped start_;
  std::vector<AlignedVector> inverseMass_, acceleration_;
  std::vector<std::vector<double>> freeMask_;
  std::vector<std::vector<int>> noLine_;
  std::vector<std::vector<unsigned char>> noSlave_;
  std::vector<BlockStep> steps_;
};

TEST(StepInPlace, GivesTheSameBits) {
  for (const auto& isa : availableInstructionSets())
    for (const std::size_t inSingle : {0U, 1U, 2U}) {
      const Stepper stepper(isa, inSingle);
      const Stepped expected = stepper.withRoom();
      for (const int parts : {1, 2, 3, 5, 7})
        for (const bool backwards : {false, true})
          EXPECT_TRUE(stepper.inPlace(parts, backwards) == expected) << isa << ", " << parts << " parts";
    }
}

}  // namespace
}  // namespace squat::elasticity
