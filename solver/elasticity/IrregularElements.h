// solver/elasticity/IrregularElements.h - elements that are not congruent with their run, as corrections to the
// operator.
//
// The swept operator treats every element of a run alike. An element whose nodes have been moved adds the difference of
// its own matrix and the run's: f = (K_own - K_run) u. Few of them, found by place.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "elasticity/SweptBlock.h"

namespace squat::elasticity {

struct IrregularElements {
  std::vector<std::array<std::size_t, 24>> unknown;    // state indices in element order
  std::vector<std::array<std::size_t, 24>> forceSlot;  // where the time loop collects forces
  std::vector<double> difference;                      // 576 per element, row-major

  std::size_t size() const { return unknown.size(); }
};

// Shift of a node in local components [m], zero where the node keeps its place; (node, station).
using NodeShift = std::function<Eigen::Vector3d(int, int)>;

// All elements of a line-swept block that have a shifted node. Throws std::invalid_argument for a Jacobian that is not
// positive.
IrregularElements irregularElements(const SweptBlock& block, const NodeShift& shift);

// result += difference * u (state layout).
void addIrregularStiffness(const IrregularElements& elements, const double* u, double* result);
// forces -= difference * u, into the force buffer.
void addIrregularForces(const IrregularElements& elements, const double* u, double* forces);

}  // namespace squat::elasticity
