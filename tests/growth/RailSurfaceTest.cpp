// Heights between the nodes of the running surface and the contact points.
#include "growth/RailSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "growth/SmallRail.h"

namespace squat::growth {
namespace {

using tests::smallGrid;
using tests::smallModel;

// Weights of a face sum to one at each of its points, so that areas and volumes are passed on whole: round-off.
TEST(RailSurface, TheMeanAtNodesKeepsTheVolume) {
  const auto& s = smallModel().surfaces;
  std::mt19937 random(7);
  std::vector<double> worn(s.points(), 0.0), one(s.points(), 1.0);
  double volume = 0;
  for (std::size_t i = 0; i < worn.size(); ++i) worn[i] = 1e-9 * static_cast<double>(random() % 1000);
  const auto grid = smallGrid();
  // Only faces inside the grid pass on what they have.
  for (int i = grid.firstStation; i + 1 < grid.firstStation + static_cast<int>(grid.x.size()); ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        const auto at = s.pointIndex(i, j, point);
        volume += s.area[at] * worn[at];
      }
  // The area that belongs to a node: what a point's area gives to it.
  const Field mean = meanAtNodes(grid, s, worn);
  std::vector<double> area(grid.size(), 0.0);
  constexpr double near = 0.5 * (1 + 0.57735026918962576), far = 1 - near;
  for (int i = grid.firstStation; i + 1 < grid.firstStation + static_cast<int>(grid.x.size()); ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point)
        for (int k = 0; k < 4; ++k) {
          const double along = (k % 2 == point % 2) ? near : far, across = (k / 2 == point / 2) ? near : far;
          const auto node =
              grid.index(static_cast<std::size_t>(i - grid.firstStation + k % 2), static_cast<std::size_t>(j + k / 2));
          area[node] += along * across * s.area[s.pointIndex(i, j, point)];
        }
  double passedOn = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) passedOn += area[i] * mean[i];
  EXPECT_NEAR(passedOn, volume, 1e-12 * volume);
  for (const double value : meanAtNodes(grid, s, one)) EXPECT_TRUE(value == 0 || std::abs(value - 1) < 1e-12);
}

// A plane is interpolated exactly.
TEST(RailSurface, AChangeRaisesTheContactPoints) {
  auto surfaces = smallModel().surfaces;
  const auto grid = smallGrid();
  const auto plane = [](double x, double y) { return 1e-5 + 2e-4 * x - 3e-4 * y; };
  Field change(grid.size());
  for (std::size_t s = 0; s < grid.x.size(); ++s)
    for (std::size_t line = 0; line < grid.y.size(); ++line)
      change[grid.index(s, line)] = plane(grid.x[s], grid.y[line]);
  const auto bare = bareSurface(surfaces);
  layChange(grid, change, 0.01, bare, surfaces);
  int raised = 0;
  for (std::size_t i = 0; i < surfaces.points(); ++i) {
    const double x = surfaces.pointX[i], rise = surfaces.height[i] - bare.height[i];
    if (x < grid.x.front() || x > grid.x.back()) {
      EXPECT_EQ(rise, 0);
      continue;
    }
    ++raised;
    EXPECT_NEAR(rise, plane(x, bare.pointY[i]), 1e-12);  // upright rail: y of a point is that of the crown
  }
  EXPECT_GT(raised, 100);
  EXPECT_DOUBLE_EQ(surfaces.reach, bare.reach + 0.01 * surfaces.radius);
  layChange(grid, Field(grid.size(), 0.0), 0, bare, surfaces);
  EXPECT_EQ(surfaces.height, bare.height);
}

// What happens everywhere alike is no shape, whatever its course across; what happens behind the reference stretch is.
TEST(RailSurface, TheShapeCountsFromTheRailFarFromTheDefect) {
  const auto grid = smallGrid();
  Field change(grid.size());
  const double middle = 0.5 * (grid.x.front() + grid.x.back());
  std::size_t at = 0;
  for (std::size_t s = 0; s < grid.x.size(); ++s) {
    if (std::abs(grid.x[s] - middle) < std::abs(grid.x[at] - middle)) at = s;
    for (std::size_t line = 0; line < grid.y.size(); ++line)
      change[grid.index(s, line)] = -1e-4 * std::cos(50 * grid.y[line]);
  }
  for (const double value : relativeShape(grid, change)) EXPECT_NEAR(value, 0, 1e-18);
  change[grid.index(at, 3)] -= 2e-5;
  const Field shape = relativeShape(grid, change);
  EXPECT_NEAR(shape[grid.index(at, 3)], -2e-5, 1e-18);
  change = Field(grid.size(), 0.0);
  change[grid.index(grid.x.size() - 1, 3)] = 1e-5;
  EXPECT_NEAR(relativeShape(grid, change)[grid.index(grid.x.size() - 1, 3)], 0, 1e-20);  // faded out
}

TEST(RailSurface, LinesAndSlopes) {
  const auto grid = smallGrid();
  Field field(grid.size());
  for (std::size_t s = 0; s < grid.x.size(); ++s)
    for (std::size_t line = 0; line < grid.y.size(); ++line)
      field[grid.index(s, line)] = 0.02 * grid.x[s] + 3 * grid.y[line];
  const double y = 0.3 * grid.y[4] + 0.7 * grid.y[5];
  const auto line = lineAt(grid, field, y);
  for (std::size_t s = 0; s < grid.x.size(); ++s) EXPECT_NEAR(line[s], 0.02 * grid.x[s] + 3 * y, 1e-12);
  EXPECT_NEAR(steepestAlong(grid, field), 0.02, 1e-9);
}

}  // namespace
}  // namespace squat::growth
