// solver/plasticity/LayerKernel.h - radial return in the elements of one group, once for each instruction set.
#pragma once

#include <cstddef>
#include <string>

namespace squat::plasticity {

// Coefficients of a shape, one after the other; where a group's elements differ, each stands 8 times, lane by lane.
// Deviatoric rows: xx, yy, 2xy, 2yz, 2zx.
namespace coefficient {
inline constexpr int strain = 0;                      // [point][24 unknowns][5]: strain[p]
inline constexpr int inner = strain + 8 * 24 * 5;     // [point][9 modes][5]: inner[p]
inline constexpr int amplitude = inner + 8 * 9 * 5;   // [point][5][9]: amplitude[p] 2 mu, on the plastic strain
inline constexpr int weight = amplitude + 8 * 5 * 9;  // [point]: 2 mu weight[p] [N m]
inline constexpr int steepest = weight + 8;           // largest strain per unit of amplitude [1/m]
inline constexpr int count = steepest + 1;
}  // namespace coefficient

inline constexpr int backstressCount = 3;

struct LayerCall {
  const double* coefficients = nullptr;
  bool own = false;              // coefficients differ from lane to lane
  const double* corner[4] = {};  // component line a of each section node at the group's first station, 64-byte aligned
  std::size_t stride = 0;        // to lines b and c
  double* state = nullptr;       // SurfaceLayer::groupState()
  double* force = nullptr;       // groupForce: [24][lane], left station first
  bool flowed = false;           // the group's plastic strain is not zero
  // Law in units of 2 mu: yield radius sqrt(2/3) sigma_y / 2 mu, its growth with equivalent plastic strain, and
  // share = 2/3 H / 2 mu of both kinds of hardening.
  double radius = 0, growth = 0, kinematicShare = 0, isotropicShare = 0;
  // Back-stresses that recover, in the same units: 2/3 modulus, recovery and largest norm of each, exponent of all;
  // what sqrt(2/3) of the isotropic growth saturates at, and its rate.
  bool recovers = false;
  double stiffness[backstressCount] = {}, recovery[backstressCount] = {}, largest[backstressCount] = {};
  double exponent = 0, saturation = 0, rate = 0;
};

struct LayerKernels {
  // Returns whether plastic strain changed; force is then renewed. u at the right stations is read one lane on.
  bool (*returnToYield)(const LayerCall&) = nullptr;
  void (*plasticForce)(const LayerCall&) = nullptr;  // force from state
};

// For a name that elasticity::kernelsFor() has accepted.
LayerKernels layerKernelsFor(const std::string& isa);

}  // namespace squat::plasticity
