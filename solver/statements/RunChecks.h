// solver/statements/RunChecks.h - what every run must show, whatever its case: little vibration before the defect,
// energy in balance.
#pragma once

#include <optional>
#include <string>

#include "results/RunResult.h"
#include "signals/SignalCatalogue.h"
#include "statements/Reference.h"

namespace squat::statements {

struct ResidualVibration {
  double largest = 0;  // [m/s2] largest deviation from the mean
  double length = 0;   // [m] of the stretch that it is taken from
};

// Over the last 0.2 m, or what there is of it, before the rail is no longer smooth; at the latest 40 mm before the
// deepest point of the defect. Nothing without the signal or with fewer than two samples there.
std::optional<ResidualVibration> residualVibration(const results::RunResult& result,
                                                   const std::string& channel = signals::names::axleBoxFiltered);

// [m/s2] The limit stands in the statement about it; nothing where the reference has none.
std::optional<double> residualVibrationLimit(const Reference& reference);

// Largest error of the energy balance, relative to the strain energy at equilibrium plus all dissipation; nothing where
// the result does not hold it.
std::optional<double> energyError(const results::RunResult& result);
inline constexpr double energyErrorLimit = 0.001;

}  // namespace squat::statements
