// solver/supports/Springs.h - springs and dampers between points of solids, and from points to the ground.
//
// A spring acts on q = sum of weight * unknown. Its elastic part acts on the displacement u + beta v (the same
// stiffness- proportional damping as the solids), its dashpot on v. Force on each unknown: -weight (stiffness q +
// damping q').
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace squat::supports {

struct SpringSet {
  std::vector<std::size_t> start{0};  // springs + 1
  std::vector<std::size_t> unknown;   // state index of each term
  std::vector<double> weight;
  std::vector<double> stiffness, damping;  // per spring [N/m], [N s/m]
  std::vector<std::size_t> forceSlot;      // of each term: where the time loop collects its force

  std::size_t size() const { return stiffness.size(); }
  void add(const std::vector<std::pair<std::size_t, double>>& terms, double k, double c);
};

struct SpringPower {
  double stored = 0;       // elastic energy [J]
  double dissipation = 0;  // [W]
};

// result += K u of the springs (state layout, no dashpots); for the equilibrium.
void addSpringStiffness(const SpringSet& set, const double* u, double* result);
void addSpringDiagonal(const SpringSet& set, double* diagonal);
SpringPower springPower(const SpringSet& set, const double* displacement, const double* velocity);

}  // namespace squat::supports
