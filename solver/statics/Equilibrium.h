// solver/statics/Equilibrium.h - static equilibrium of track, wheelset and sprung mass with frictionless contact.
//
// Newton's method on the active set of contact points and the tangents of the force elements; each linear system by
// conjugate gradients with a coarse space (CoarseSpace.h). Load: weight of everything. The sprung mass is fixed along
// the track, the wheelset's mean rotation is fixed and taken out of the result.
#pragma once

#include <vector>

#include "core/Monitor.h"
#include "statics/StaticSystem.h"

namespace squat::statics {

struct EquilibriumOptions {
  double tolerance = 1e-7;  // residual 2-norm relative to the wheel load
  int maximumNewtonSteps = 40;
  int maximumIterations = 20000;         // of conjugate gradients in all
  const AlignedVector* guess = nullptr;  // of all halves
};

struct Equilibrium {
  AlignedVector displacement;       // state layout
  double wheelX = 0, rotation = 0;  // where the wheel stands
  double contactForce = 0;          // [N] vertical
  double lateralForce = 0;          // [N] of the wheel on the rail, outwards
  double centreLateral = 0;         // [m] y of the pressure's centre
  double residual = 0;              // 2-norm relative to the wheel load
  double rigidHeight = 0;  // [m] at which the wheel would stand by its tread's deviation alone, rigid on a rigid rail
  double approach = 0;  // [m] deflection of the rail's section under the wheel, mean over its mass, less the hub's over
                        // that height
  double halfAxisRolling = 0, halfAxisLateral = 0;  // [m] sqrt(5 <x^2>), sqrt(5 <y^2>) of the pressure
  double peakPressure = 0;                          // [Pa] 3 N / (2 pi a b)
  double strainEnergy = 0;                          // [J] solids, springs and contact
  int newtonSteps = 0, iterations = 0;
  bool cancelled = false;
};

// Of every half of a system, which it assembles; throws RunError when it does not converge or a wheel finds no contact.
std::vector<Equilibrium> findEquilibria(StaticSystem& system, double wheelX, const EquilibriumOptions& options,
                                        Monitor& monitor);
// Of a half model.
Equilibrium findEquilibrium(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                            double wheelX, double rotation, const EquilibriumOptions& options, Monitor& monitor);

// How the equilibrium changes as the wheel rolls on: du/dx per metre [1] of all halves, wheelset in the bases of
// rotation zero; `system` as findEquilibria() has left it, at rotation zero. One linear system with the closed contact:
// K_T du/dx = dR/dx, R the residual with the material fixed and the wheel moved and turned.
AlignedVector equilibriumRate(StaticSystem& system, const std::vector<Equilibrium>& found, Monitor& monitor);

}  // namespace squat::statics
