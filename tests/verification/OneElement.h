// tests/verification/OneElement.h - one element of steel that yields, strained as a test wants it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "elasticity/SweptKernel.h"
#include "elasticity/SweptSamples.h"
#include "plasticity/LayerKernel.h"
#include "plasticity/LayerWork.h"
#include "scenario/Track.h"

namespace squat::tests {

// A brick of one element in each of eight lanes, all strained alike.
class Brick {
 public:
  Brick(const scenario::Rail& rail, const std::string& isa) : kernels_(plasticity::layerKernelsFor(isa)) {
    blocks_.resize(1);
    auto& block = blocks_[0];
    block.section = elasticity::gridSection(elasticity::evenly(0, 0.004, 1), elasticity::evenly(0, 0.004, 1), 0);
    block.stations = {0, false, {{8, 0.004}}};
    block.material = elasticity::steel;
    size_ = elasticity::layOut(blocks_);
    layer_ = plasticity::makeLayer(block, plasticity::hardeningLaw(rail), {2, 3}, 0.1, 0, 8);
    state_ = plasticity::restState(layer_);
    forces_ = plasticity::layerForces(layer_, kernels_, state_);
  }

  // To a homogeneous strain xx, yy, zz, 2xy, 2yz, 2zx.
  void strain(const std::array<double, 6>& e) {
    AlignedVector u(size_, 0.0);
    elasticity::setField(
        blocks_[0],
        [&](const Eigen::Vector3d& p) {
          return Eigen::Vector3d(e[0] * p[0] + 0.5 * e[3] * p[1] + 0.5 * e[5] * p[2],
                                 e[1] * p[1] + 0.5 * e[3] * p[0] + 0.5 * e[4] * p[2],
                                 e[2] * p[2] + 0.5 * e[4] * p[1] + 0.5 * e[5] * p[0]);
        },
        u);
    plasticity::returnWindow(layer_, kernels_, u.data(), 0.016, 1, 0, 1, state_, forces_);
  }
  std::array<double, 6> plastic() const { return plasticity::elementFlow(layer_, state_, 0, 3).strain; }
  double equivalent() const { return plasticity::elementFlow(layer_, state_, 0, 3).equivalent; }
  double dissipated() const {  // [J/m3]
    AlignedVector still(size_, 0.0);
    const auto energy = plasticity::layerEnergy(layer_, state_, forces_, still.data());
    return (energy.dissipated + energy.hardening) / (0.004 * 0.004 * 8 * 0.004);
  }
  struct Kept {
    plasticity::LayerState state;
    plasticity::LayerForces forces;
  };
  Kept keep() const { return {state_, forces_}; }
  void giveBack(const Kept& kept) { state_ = kept.state, forces_ = kept.forces; }

 private:
  std::vector<elasticity::SweptBlock> blocks_;
  std::size_t size_ = 0;
  plasticity::SurfaceLayer layer_;
  plasticity::LayerKernels kernels_;
  plasticity::LayerState state_;
  plasticity::LayerForces forces_;
};

}  // namespace squat::tests
