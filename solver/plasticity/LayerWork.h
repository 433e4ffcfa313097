// solver/plasticity/LayerWork.h - the yielding layer in the time loop: a moving window of groups is returned to yield,
// the forces of all plastic strain go into the force lines of the rail.
#pragma once

#include <array>
#include <vector>

#include "plasticity/LayerKernel.h"
#include "plasticity/SurfaceLayer.h"

namespace squat::plasticity {

// Derived from the state, so never stored: force of each group, and whether it has flowed.
struct LayerForces {
  AlignedVector values;  // groups x groupForce
  std::vector<unsigned char> flowed;
};
LayerForces layerForces(const SurfaceLayer& layer, const LayerKernels& kernels, LayerState& state);

// Returns the groups within `reach` [m] of the wheel at x to yield, those of part `part` of `parts`; parts touch
// different memory. `displaced` (state layout) is u + beta v: what the elasticity of the step acts on, so that the
// stress which yields is the stress that the elements have. Groups farther away keep their plastic strain.
void returnWindow(const SurfaceLayer& layer, const LayerKernels& kernels, const double* displaced, double x,
                  double reach, int part, int parts, LayerState& state, LayerForces& forces);

// Adds the forces of all plastic strain on stations [first, end) to the force lines of the rail. first and end are
// multiples of 8; the layer does not reach the rail's last station. Sums are ordered: cuts between stretches do not
// show.
void addPlasticForces(const SurfaceLayer& layer, const LayerForces& forces, int first, int end, double* lines,
                      const int* lineOfNode);

// Means over the points of an element: plastic strain (xx, yy, zz, 2xy, 2yz, 2zx) and equivalent plastic strain; zero
// outside the layer.
struct ElementFlow {
  std::array<double, 6> strain{};
  double equivalent = 0;
};
ElementFlow elementFlow(const SurfaceLayer& layer, const LayerState& state, int sectionQuad, int interval);

// Energy of the plastic strain eps_p: what has to be added to 1/2 u.K u to get the elastic energy, what hardening
// stores (1/2 H p^2, 1/3 H eps_p:eps_p or the sum of 3/4 X:X / modulus) and what flow has dissipated (sigma_y p with
// linear hardening; else all plastic work but what is stored).
struct LayerEnergy {
  double elastic = 0, hardening = 0, dissipated = 0;  // [J]
};
LayerEnergy layerEnergy(const SurfaceLayer& layer, const LayerState& state, const LayerForces& forces, const double* u);

double largestEquivalentStrain(const SurfaceLayer& layer, const LayerState& state);

}  // namespace squat::plasticity
