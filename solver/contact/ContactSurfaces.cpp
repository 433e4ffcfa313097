#include "contact/ContactSurfaces.h"

#include <algorithm>
#include <cmath>

#include "case/DefectSurface.h"
#include "geometry/RailSection.h"
#include "geometry/SectionMesh.h"

namespace squat::contact {

namespace {

// Beyond this |y| the crown lies so far below the tread that no load presses it on [m].
constexpr double reach = 0.017;

std::vector<double> lateralPositions(const elasticity::SweptBlock& block, const std::vector<int>& line, int axis) {
  std::vector<double> y;
  for (const int node : line) y.push_back(block.section.nodes[node][axis]);
  return y;
}

}  // namespace

Surfaces makeSurfaces(const elasticity::SweptBlock& rail, int railBlock, const elasticity::SweptBlock& rim,
                      int rimBlock, const cases::CaseDescription& description, double from, double to) {
  Surfaces s;
  s.railBlock = railBlock, s.rimBlock = rimBlock;
  s.radius = description.wheelset.radius;
  s.railLine = geometry::nodesWhere(
      rail.section,
      [](const geometry::Point2& p) {
        return std::abs(p[0]) < 0.0245 && std::abs(p[1] - geometry::crownHeight54E1(p[0])) < 1e-6;
      },
      0);
  s.treadLine = geometry::nodesWhere(
      rim.section, [&](const geometry::Point2& p) { return std::abs(p[0] - s.radius) < 1e-9; }, 1);
  s.railY = lateralPositions(rail, s.railLine, 0);
  s.treadY = lateralPositions(rim, s.treadLine, 1);
  int lastColumn = -1;
  s.firstColumn = static_cast<int>(s.railLine.size());
  for (int j = 0; j + 1 < static_cast<int>(s.railLine.size()); ++j)
    if (s.railY[j + 1] > -reach && s.railY[j] < reach) s.firstColumn = std::min(s.firstColumn, j), lastColumn = j;
  s.columns = lastColumn - s.firstColumn + 1;
  s.firstInterval = 0;
  while (rail.positions[s.firstInterval + 1] <= from) ++s.firstInterval;
  while (s.firstInterval + s.intervals < rail.intervals && rail.positions[s.firstInterval + s.intervals] < to)
    ++s.intervals;

  s.rolledInterval = s.firstInterval;

  const double gauss = 1 / std::sqrt(3.0);
  for (int j = 0; j < s.columns; ++j)
    for (int lateral = 0; lateral < 2; ++lateral) {
      const double y0 = s.railY[s.firstColumn + j], y1 = s.railY[s.firstColumn + j + 1];
      const double y = 0.5 * (y0 + y1) + (lateral ? gauss : -gauss) * 0.5 * (y1 - y0);
      int column = static_cast<int>(std::upper_bound(s.treadY.begin(), s.treadY.end(), y) - s.treadY.begin()) - 1;
      column = std::clamp(column, 0, static_cast<int>(s.treadY.size()) - 2);
      s.treadColumn.push_back(column);
      s.treadFraction.push_back((y - s.treadY[column]) / (s.treadY[column + 1] - s.treadY[column]));
    }
  const cases::DefectSurface defect(description.defect);
  for (int i = s.firstInterval; i < s.firstInterval + s.intervals; ++i)
    for (int j = 0; j < s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        const double x0 = rail.positions[i], x1 = rail.positions[i + 1];
        const double y0 = s.railY[s.firstColumn + j], y1 = s.railY[s.firstColumn + j + 1];
        const double x = 0.5 * (x0 + x1) + (point % 2 ? gauss : -gauss) * 0.5 * (x1 - x0);
        const double y = 0.5 * (y0 + y1) + (point / 2 ? gauss : -gauss) * 0.5 * (y1 - y0);
        s.pointX.push_back(x), s.pointY.push_back(y);
        s.height.push_back(geometry::crownHeight54E1(y) + defect.height(x, y));
        s.area.push_back((x1 - x0) * (y1 - y0) * std::hypot(1.0, geometry::crownSlope54E1(y)) / 4);
      }
  return s;
}

}  // namespace squat::contact
