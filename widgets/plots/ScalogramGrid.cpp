#include "plots/ScalogramGrid.h"

#include <algorithm>
#include <cmath>

namespace squat::plots {
namespace {

constexpr int gridRows = 240, gridColumns = 480;

struct Location {
  std::size_t below = 0;
  double weight = 0;  // of the next one
};

// Where `value` lies between the entries of an ascending list.
Location locationIn(const std::vector<double>& ascending, double value) {
  const auto above = std::upper_bound(ascending.begin(), ascending.end(), value);
  if (above == ascending.begin()) return {};
  if (above == ascending.end()) return {ascending.size() - 2, 1.0};
  const auto below = static_cast<std::size_t>(above - ascending.begin()) - 1;
  const double span = ascending[below + 1] - ascending[below];
  return {below, span > 0 ? (value - ascending[below]) / span : 0.0};
}

}  // namespace

ScalogramGrid scalogramGrid(const results::AnalysedRecord& result, double positionFrom, double positionTo,
                            double frequencyFrom, double frequencyTo) {
  const std::size_t rows = result.scalogramFrequency.size();
  std::vector<double> position = result.scalogramPosition;
  const std::size_t columns = position.size();
  if (rows < 2 || columns < 2 || result.scalogramPower.size() != rows * columns) return {};
  // Frequencies may be stored from high to low.
  const bool descending = result.scalogramFrequency.front() > result.scalogramFrequency.back();
  std::vector<double> logFrequency(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double frequency = result.scalogramFrequency[descending ? rows - 1 - row : row];
    if (!(frequency > 0)) return {};
    logFrequency[row] = std::log(frequency);
  }
  ScalogramGrid grid;
  grid.positionFrom = std::max(positionFrom, position.front());
  grid.positionTo = std::min(positionTo, position.back());
  grid.frequencyFrom = std::max(frequencyFrom, std::exp(logFrequency.front()));
  grid.frequencyTo = std::min(frequencyTo, std::exp(logFrequency.back()));
  if (!(grid.positionTo > grid.positionFrom) || !(grid.frequencyTo > grid.frequencyFrom)) return {};
  grid.rows = gridRows;
  grid.columns = gridColumns;
  grid.power.resize(static_cast<std::size_t>(gridRows) * gridColumns);
  const bool hasCone = result.coneOfInfluence.size() == columns;
  if (hasCone) grid.cone.resize(gridColumns);
  for (int column = 0; column < gridColumns; ++column) {
    const double share = static_cast<double>(column) / (gridColumns - 1);
    const Location at = locationIn(position, grid.positionFrom + share * (grid.positionTo - grid.positionFrom));
    if (hasCone)
      grid.cone[column] =
          (1 - at.weight) * result.coneOfInfluence[at.below] + at.weight * result.coneOfInfluence[at.below + 1];
    for (int row = 0; row < gridRows; ++row) {
      const double logShare = static_cast<double>(row) / (gridRows - 1);
      const double wanted = std::log(grid.frequencyFrom) + logShare * std::log(grid.frequencyTo / grid.frequencyFrom);
      const Location up = locationIn(logFrequency, wanted);
      const auto power = [&](std::size_t r, std::size_t c) {
        const std::size_t stored = descending ? rows - 1 - r : r;
        const double value = result.scalogramPower[stored * columns + c];
        return std::isfinite(value) ? value : 0.0;
      };
      const double value =
          (1 - up.weight) * ((1 - at.weight) * power(up.below, at.below) + at.weight * power(up.below, at.below + 1)) +
          up.weight * ((1 - at.weight) * power(up.below + 1, at.below) + at.weight * power(up.below + 1, at.below + 1));
      grid.power[static_cast<std::size_t>(row) * gridColumns + column] = value;
      grid.largestPower = std::max(grid.largestPower, value);
    }
  }
  return grid;
}

}  // namespace squat::plots
