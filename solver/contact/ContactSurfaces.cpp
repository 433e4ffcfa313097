#include "contact/ContactSurfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/ElementaryFunctions.h"
#include "core/Errors.h"
#include "geometry/RailSection.h"
#include "geometry/SectionMesh.h"
#include "scenario/DefectSurface.h"
#include "scenario/Scenario.h"

namespace squat::contact {

namespace {

// At this distance from where it touches the crown lies so far below the tread that no load presses it on [m].
constexpr double reach = 0.017;
const double gauss = 1 / std::sqrt(3.0);

std::vector<double> lateralPositions(const elasticity::SweptBlock& block, const std::vector<int>& line, int axis) {
  std::vector<double> y;
  for (const int node : line) y.push_back(block.section.nodes[node][axis]);
  return y;
}

struct CrownArc {
  double height = 0, angle = 0;  // [m], [rad] of its slope
};
CrownArc crownOf(scenario::RailSection section, double y) {
  return {geometry::crownHeight(section, y), elementary::atan(geometry::crownSlope(section, y))};
}

}  // namespace

// On a slope the wheel touches radius times slope beside its lowest point, though not farther than the defect goes; the
// patch, 7 mm each way, comes on top. On smooth rail 20 mm hold any patch. A tread that is not round and a rail that is
// not smooth touch farther off by what their own slopes add.
double reachAlong(const scenario::Scenario& scenario, double radius) {
  constexpr double minimum = 0.020, patch = 0.012;  // [m]
  const auto& defect = scenario.defectSurface;
  const double onDefect = std::min(radius * defect.steepest(), 0.5 * (defect.last() - defect.first()));
  return std::max(minimum,
                  onDefect + scenario.tread.touchReach(radius) + patch + radius * scenario.irregularity.steepest());
}

WheelSeat seatOf(const scenario::Scenario& d) {
  const geometry::RailProfile& profile = geometry::railProfile(d.rail.section);
  const double edge = profile.touchEnd;
  const auto crownAt = [&](double y) { return crownOf(d.rail.section, y); };
  WheelSeat seat;
  seat.lean = elementary::atan(d.rail.inclination);
  const double offset = d.motion.lateralOffset;
  const double tread = elementary::atan(d.wheelset.cone) + crownAt(offset).angle, wanted = tread - seat.lean;
  if (wanted > crownAt(-edge).angle || wanted < crownAt(edge).angle)
    throw CaseError({{"wheelset.cone", std::to_string(d.wheelset.cone), "a slope that the crown has somewhere",
                      "Choose wheelset.cone near rail.inclination, and motion.lateral_offset smaller"}});
  double low = -edge, high = edge;  // the slope falls with y
  for (int i = 0; i < 60 && wanted != crownAt(offset).angle; ++i) {
    const double middle = 0.5 * (low + high);
    (crownAt(middle).angle > wanted ? low : high) = middle;
  }
  seat.touchY = wanted == crownAt(offset).angle ? offset : 0.5 * (low + high);
  seat.crownRadius = std::abs(seat.touchY) <= profile.crownEnd ? profile.crownRadius : profile.shoulderRadius;
  seat.treadSlope = elementary::tan(tread);
  const double c = elementary::cos(seat.lean), s = elementary::sin(seat.lean);
  const CrownArc under = crownAt(offset), touch = crownAt(seat.touchY);
  seat.wheelY = offset * c - under.height * s;
  seat.radius = d.wheelset.radius - seat.treadSlope * (seat.touchY * c - touch.height * s - seat.wheelY);
  seat.centreHeight = seat.touchY * s + touch.height * c + seat.radius;
  return seat;
}

Columns touchedColumns(const std::vector<double>& railY, double y) {
  const int faces = static_cast<int>(railY.size()) - 1;
  int first = faces + 1, last = -1;
  for (int j = 0; j < faces; ++j)
    if (railY[j + 1] > y - reach && railY[j] < y + reach) first = std::min(first, j), last = j;
  return {first, last - first + 1};
}

std::vector<int> runningLine(const elasticity::SweptBlock& rail, scenario::RailSection section) {
  return geometry::nodesWhere(
      rail.section,
      [&](const geometry::Point2& p) {
        return std::abs(p[0]) < 0.0245 && std::abs(p[1] - geometry::crownHeight(section, p[0])) < 1e-6;
      },
      0);
}

Surfaces makeSurfaces(const elasticity::SweptBlock& rail, int railBlock, const elasticity::SweptBlock& rim,
                      int rimBlock, const scenario::Scenario& scenario, double from, double to) {
  Surfaces s;
  s.railBlock = railBlock, s.rimBlock = rimBlock;
  const WheelSeat seat = seatOf(scenario);
  const auto section = s.section = scenario.rail.section;
  s.radius = seat.radius, s.crownRadius = seat.crownRadius, s.touchY = seat.touchY;
  s.railCosine = elementary::cos(seat.lean), s.railSine = elementary::sin(seat.lean);
  s.treadCosine = 1 / elementary::hypot(1.0, seat.treadSlope), s.treadSine = seat.treadSlope * s.treadCosine;
  const auto treadRadius = [&](double y) { return scenario.wheelset.radius - seat.treadSlope * y; };
  s.railLine = runningLine(rail, section);
  s.treadLine = geometry::nodesWhere(
      rim.section, [&](const geometry::Point2& p) { return std::abs(p[0] - treadRadius(p[1])) < 1e-9; }, 1);
  s.railY = lateralPositions(rail, s.railLine, 0);
  s.treadY = lateralPositions(rim, s.treadLine, 1);
  const Columns touched = touchedColumns(s.railY, s.touchY);
  s.firstColumn = touched.first, s.columns = touched.count;
  s.firstInterval = 0;
  while (rail.positions[s.firstInterval + 1] <= from) ++s.firstInterval;
  while (s.firstInterval + s.intervals < rail.intervals && rail.positions[s.firstInterval + s.intervals] < to)
    ++s.intervals;

  s.rolledInterval = s.firstInterval;

  for (int j = 0; j < s.columns; ++j)
    for (int lateral = 0; lateral < 2; ++lateral) {
      const double y0 = s.railY[s.firstColumn + j], y1 = s.railY[s.firstColumn + j + 1];
      const double onCrown = 0.5 * (y0 + y1) + (lateral ? gauss : -gauss) * 0.5 * (y1 - y0);
      const double y =
          onCrown * s.railCosine - geometry::crownHeight(section, onCrown) * s.railSine - seat.wheelY;  // on the wheel
      s.treadRadius.push_back(treadRadius(y));
      int column = static_cast<int>(std::upper_bound(s.treadY.begin(), s.treadY.end(), y) - s.treadY.begin()) - 1;
      column = std::clamp(column, 0, static_cast<int>(s.treadY.size()) - 2);
      if (!scenario.tread.isRound()) s.treadCurve.push_back(scenario.tread.curveAt(y));
      s.treadColumn.push_back(column);
      s.treadFraction.push_back((y - s.treadY[column]) / (s.treadY[column + 1] - s.treadY[column]));
    }
  s.treadAhead = scenario.tread.angleAt(-scenario.motion.runUp, s.radius);
  s.treadHighest = std::max(0.0, scenario.tread.highest()), s.treadSteepest = scenario.tread.steepest();
  layDefect(s, rail, scenario);
  return s;
}

namespace {

// Of the irregularity at both Gauss points along an interval, the same in all columns [m].
std::array<double, 2> heightsIn(const elasticity::SweptBlock& rail, int interval,
                                const scenario::IrregularSurface& irregularity) {
  const double x0 = rail.positions[interval], x1 = rail.positions[interval + 1];
  const double middle = 0.5 * (x0 + x1), half = gauss * 0.5 * (x1 - x0);
  return {irregularity.height(middle - half), irregularity.height(middle + half)};
}

}  // namespace

void layDefect(Surfaces& s, const elasticity::SweptBlock& rail, const scenario::Scenario& scenario) {
  const auto& defect = scenario.defectSurface;
  const auto& irregularity = scenario.irregularity;
  s.reach = reachAlong(scenario, s.radius);
  s.height.clear(), s.area.clear(), s.pointX.clear(), s.pointY.clear();
  for (int i = s.firstInterval; i < s.firstInterval + s.intervals; ++i) {
    const std::array<double, 2> along = heightsIn(rail, i, irregularity);
    for (int j = 0; j < s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        const double x0 = rail.positions[i], x1 = rail.positions[i + 1];
        const double y0 = s.railY[s.firstColumn + j], y1 = s.railY[s.firstColumn + j + 1];
        const double x = 0.5 * (x0 + x1) + (point % 2 ? gauss : -gauss) * 0.5 * (x1 - x0);
        const double y = 0.5 * (y0 + y1) + (point / 2 ? gauss : -gauss) * 0.5 * (y1 - y0);
        const double z = geometry::crownHeight(s.section, y) + defect.height(x, y) + along[point % 2];
        s.pointX.push_back(x), s.pointY.push_back(y * s.railCosine - z * s.railSine);
        s.height.push_back(y * s.railSine + z * s.railCosine);
        s.area.push_back((x1 - x0) * (y1 - y0) * elementary::hypot(1.0, geometry::crownSlope(s.section, y)) / 4);
      }
  }
}

}  // namespace squat::contact
