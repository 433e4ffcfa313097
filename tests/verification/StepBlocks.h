// tests/verification/StepBlocks.h - bare blocks stepped by the central difference: no supports, no contact.
#pragma once

#include <vector>

#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"

namespace squat::elasticity {

class FreeBlocks {
 public:
  explicit FreeBlocks(std::vector<SweptBlock> blocks, double beta = 0);

  const std::vector<SweptBlock>& blocks() const { return blocks_; }
  AlignedVector& displacement() { return displaced_; }
  AlignedVector& velocity() { return velocity_; }  // half a step behind
  void advance(double step, int steps, int parts = 1, const std::string& isa = "");
  // Highest eigenvalue of M^-1 K by power steps [1/s2]; from below.
  double highestEigenvalue(int iterations);

 private:
  std::vector<SweptBlock> blocks_;
  double beta_;
  AlignedVector displaced_, velocity_, target_;
  std::vector<AlignedVector> inverseMass_, acceleration_;
  std::vector<std::vector<double>> freeMask_;
  std::vector<std::vector<int>> lineOfNode_;
  std::vector<std::vector<unsigned char>> slave_;
};

}  // namespace squat::elasticity
