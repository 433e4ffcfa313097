#include "growth/RailSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/Errors.h"

namespace squat::growth {

namespace {

constexpr double offMiddle = std::numbers::inv_sqrt3;  // of the contact points in their faces

struct Corner {
  std::size_t node = 0;
  double weight = 0;
};

// Bilinear weights of the nodes about a contact point; nothing where the point lies outside the grid.
bool cornersOf(const SurfaceGrid& grid, int interval, int column, int point, std::array<Corner, 4>& corners) {
  const int station = interval - grid.firstStation;
  if (station < 0 || station + 1 >= static_cast<int>(grid.x.size())) return false;
  const double along = 0.5 * (1 + (point % 2 ? offMiddle : -offMiddle)),
               across = 0.5 * (1 + (point / 2 ? offMiddle : -offMiddle));
  for (int k = 0; k < 4; ++k) {
    const auto s = static_cast<std::size_t>(station + k % 2), line = static_cast<std::size_t>(column + k / 2);
    corners[k] = {grid.index(s, line), (k % 2 ? along : 1 - along) * (k / 2 ? across : 1 - across)};
  }
  return true;
}

// f(point index, corners) for every contact point on the grid.
template <typename F>
void forPoints(const SurfaceGrid& grid, const contact::Surfaces& s, const F& f) {
  std::array<Corner, 4> corners;
  for (int i = s.firstInterval; i < s.firstInterval + s.intervals; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point)
        if (cornersOf(grid, i, j, point, corners)) f(s.pointIndex(i, j, point), corners);
}

double fade(const SurfaceGrid& grid, double x) {
  const double end = std::min(x - grid.x.front(), grid.x.back() - x);
  return end >= grid.taper ? 1 : 0.5 * (1 - std::cos(std::numbers::pi * std::max(end, 0.0) / grid.taper));
}

// Means over the reference stretch, line by line.
std::vector<double> referenceOf(const SurfaceGrid& grid, const Field& change) {
  std::vector<double> mean(grid.y.size(), 0.0);
  int count = 0;
  for (std::size_t s = 0; s < grid.x.size(); ++s) {
    if (grid.x[s] < grid.referenceFrom || grid.x[s] > grid.referenceTo) continue;
    ++count;
    for (std::size_t line = 0; line < grid.y.size(); ++line) mean[line] += change[grid.index(s, line)];
  }
  for (double& value : mean) value /= std::max(count, 1);
  return mean;
}

double valueAt(const std::vector<double>& y, const double* values, double at) {
  const auto upper = std::clamp<std::size_t>(std::upper_bound(y.begin(), y.end(), at) - y.begin(), 1, y.size() - 1);
  const double t = std::clamp((at - y[upper - 1]) / (y[upper] - y[upper - 1]), 0.0, 1.0);
  return (1 - t) * values[upper - 1] + t * values[upper];
}

}  // namespace

SurfaceGrid surfaceGrid(const model::Model& model, double from, double to) {
  const auto& at = model.blocks[model.rail].positions;
  SurfaceGrid grid;
  while (at[grid.firstStation] < from - 1e-9) ++grid.firstStation;
  for (auto s = static_cast<std::size_t>(grid.firstStation); s < at.size() && at[s] <= to + 1e-9; ++s)
    grid.x.push_back(at[s]);
  grid.y = model.surfaces.railY, grid.nodes = model.surfaces.railLine;
  return grid;
}

Field meanAtNodes(const SurfaceGrid& grid, const contact::Surfaces& surfaces, const std::vector<double>& atPoints) {
  Field sum(grid.size(), 0.0), area(grid.size(), 0.0);
  forPoints(grid, surfaces, [&](std::size_t point, const auto& corners) {
    for (const auto& corner : corners) {
      sum[corner.node] += corner.weight * surfaces.area[point] * atPoints[point];
      area[corner.node] += corner.weight * surfaces.area[point];
    }
  });
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (area[i] > 0) sum[i] /= area[i];
  return sum;
}

Field risenNodes(const SurfaceGrid& grid, const model::Model& model, const AlignedVector& displacement) {
  Field risen(grid.size(), 0.0);
  const auto& rail = model.blocks[model.rail];
  for (std::size_t s = 0; s < grid.x.size(); ++s)
    for (std::size_t line = 0; line < grid.y.size(); ++line)
      risen[grid.index(s, line)] =
          displacement[rail.index(grid.nodes[line], 2, grid.firstStation + static_cast<int>(s))];
  return risen;
}

Field relativeShape(const SurfaceGrid& grid, const Field& change) {
  const auto reference = referenceOf(grid, change);
  Field shape(change.size());
  for (std::size_t s = 0; s < grid.x.size(); ++s)
    for (std::size_t line = 0; line < grid.y.size(); ++line) {
      const auto i = grid.index(s, line);
      shape[i] = fade(grid, grid.x[s]) * (change[i] - reference[line]);
    }
  return shape;
}

double referenceHeight(const SurfaceGrid& grid, const Field& change, double y) {
  return valueAt(grid.y, referenceOf(grid, change).data(), y);
}

std::vector<double> lineAt(const SurfaceGrid& grid, const Field& field, double y) {
  std::vector<double> line;
  for (std::size_t s = 0; s < grid.x.size(); ++s) line.push_back(valueAt(grid.y, &field[grid.index(s, 0)], y));
  return line;
}

double steepestAlong(const SurfaceGrid& grid, const Field& shape) {
  double steepest = 0;
  for (std::size_t s = 0; s + 1 < grid.x.size(); ++s)
    for (std::size_t line = 0; line < grid.y.size(); ++line)
      steepest = std::max(steepest, std::abs(shape[grid.index(s + 1, line)] - shape[grid.index(s, line)]) /
                                        (grid.x[s + 1] - grid.x[s]));
  return steepest;
}

BareSurface bareSurface(const contact::Surfaces& s) { return {s.height, s.pointY, s.reach}; }

void layChange(const SurfaceGrid& grid, const Field& change, double steepest, const BareSurface& bare,
               contact::Surfaces& s) {
  s.height = bare.height, s.pointY = bare.pointY;
  s.reach = bare.reach + s.radius * steepest;
  forPoints(grid, s, [&](std::size_t point, const auto& corners) {
    double rise = 0;
    for (const auto& corner : corners) rise += corner.weight * change[corner.node];
    s.height[point] += rise * s.railCosine;
    s.pointY[point] -= rise * s.railSine;
  });
}

}  // namespace squat::growth
