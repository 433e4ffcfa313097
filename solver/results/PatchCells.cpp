#include "results/PatchCells.h"

#include <algorithm>
#include <cmath>

namespace squat::results {
namespace {

// Places of columns (or rows), rising; what lies nearer together than `same` is one.
std::vector<double> lines(const std::vector<float>& values, double same) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> found;
  for (const double value : sorted)
    if (found.empty() || value - found.back() > same) found.push_back(value);
  return found;
}

struct Span {
  double low, high;
};

Span spanAround(double value, const std::vector<double>& lines, double alone) {
  const auto after = std::lower_bound(lines.begin(), lines.end(), value + 1e-9);
  const auto own = after == lines.begin() ? after : after - 1;
  const bool below = own != lines.begin(), above = own + 1 != lines.end();
  const double down = below ? (*own - *(own - 1)) / 2 : above ? (*(own + 1) - *own) / 2 : alone / 2;
  const double up = above ? (*(own + 1) - *own) / 2 : down;
  return {*own - down, *own + up};
}

}  // namespace

std::vector<PatchCell> patchCells(const PatchSnapshot& patch) {
  const std::size_t count = patch.pressure.size();
  if (count == 0 || patch.x.size() != count || patch.y.size() != count) return {};
  double area = 0;
  for (const float each : patch.area) area = std::max(area, static_cast<double>(each));
  const double side = area > 0 ? std::sqrt(area) : 1e-3;
  constexpr double share = 0.2;  // of a point's side: the columns of a mesh lie farther apart
  const auto columns = lines(patch.x, share * side), rows = lines(patch.y, share * side);
  std::vector<PatchCell> cells;
  for (std::size_t i = 0; i < count; ++i) {
    const Span along = spanAround(static_cast<double>(patch.x[i]), columns, side);
    const Span across = spanAround(static_cast<double>(patch.y[i]), rows, side);
    cells.push_back({along.low, along.high, across.low, across.high});
  }
  return cells;
}

}  // namespace squat::results
