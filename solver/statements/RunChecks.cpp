#include "statements/RunChecks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace squat::statements {

namespace {

constexpr double stretch = 0.2, latestEnd = -0.04;  // [m]

double defectBegins(const results::RunResult& result) {
  for (std::size_t i = 0; i < result.profileHeight.size(); ++i)
    if (result.profileHeight[i] != 0) return std::min(latestEnd, result.profilePosition[i]);
  return latestEnd;
}

}  // namespace

std::optional<ResidualVibration> residualVibration(const results::RunResult& result, const std::string& channel) {
  const auto* values = result.signal(channel);
  if (!values || values->size() != result.position.size()) return std::nullopt;
  const double end = defectBegins(result);
  double first = end;
  std::vector<double> window;
  for (std::size_t i = 0; i < values->size(); ++i)
    if (result.position[i] >= end - stretch && result.position[i] <= end) {
      first = std::min(first, result.position[i]);
      window.push_back((*values)[i]);
    }
  if (window.size() < 2) return std::nullopt;
  double mean = 0;
  for (const double value : window) mean += value / static_cast<double>(window.size());
  ResidualVibration seen{0, end - first};
  for (const double value : window) seen.largest = std::max(seen.largest, std::abs(value - mean));
  return seen;
}

std::optional<double> residualVibrationLimit(const Reference& reference) {
  for (const auto& statement : reference.statements)
    if (statement.measure == "residual_vibration") return statement.high;
  return std::nullopt;
}

std::optional<double> energyError(const results::RunResult& result) {
  for (const auto& scalar : result.performance)
    if (scalar.name == "energy_residual") return std::abs(scalar.value);
  return std::nullopt;
}

}  // namespace squat::statements
