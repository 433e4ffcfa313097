// tests/simulation/QuietRuns.h - runs without pictures and modes, and figures of what comes of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/RunCase.h"

namespace squat::tests {

inline simulation::RunOptions quietly(int threads = 2) {
  simulation::RunOptions options;
  options.threads = threads;
  options.wheelsetModes = options.snapshots = false;
  return options;
}

inline results::RunResult rolled(const cases::CaseDescription& description, int threads = 2) {
  Monitor silent;
  return simulation::runCase(description, quietly(threads), silent);
}

// Largest absolute value.
inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// Of the energy balance, relative; infinite where a result has none.
inline double energyResidual(const results::RunResult& result) {
  for (const auto& figure : result.performance)
    if (figure.name == "energy_residual") return figure.value;
  return INFINITY;
}

}  // namespace squat::tests
