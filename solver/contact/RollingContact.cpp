#include "contact/RollingContact.h"

#include <algorithm>
#include <cmath>

namespace squat::contact {

namespace {

constexpr double nearGap = 1.5e-3;  // [m] undeformed gap that deflections of the track may close

void addForce(const elasticity::SweptBlock& block, const ForceLines& to, int node, int component, int first, int second,
              double atFirst, double atSecond) {
  double* line = to.lines + (static_cast<std::size_t>(to.lineOfNode[node]) * 3 + component) * block.stride;
  line[first] += atFirst;
  line[second] += atSecond;
}

struct Sums {
  double n = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
};

}  // namespace

std::vector<RailPoint> pointsWithin(double margin, const Surfaces& s, const elasticity::SweptBlock& rail,
                                    const elasticity::SweptBlock& rim, const WheelPlacement& wheel,
                                    const double* displaced) {
  std::vector<RailPoint> found;
  TouchPoint t;
  const auto [first, last] = reachableIntervals(s, rail, wheel.centreX + wheel.hubX, s.reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point)
        if (evaluatePoint(s, rail, rim, displaced, wheel, i, j, point, nearGap, t) && t.penetration > -margin)
          found.push_back({i, j, point});
  return found;
}

PatchState rollContact(const Surfaces& s, const elasticity::SweptBlock& rail, const elasticity::SweptBlock& rim,
                       const ContactLaw& law, const WheelRolling& wheel, const double* displaced,
                       const double* velocity, double step, FrictionHistory& history, const ForceLines& railForces,
                       const ForceLines& rimForces, std::vector<PatchPoint>* points, ClosedArea* closed,
                       const std::vector<RailPoint>* among) {
  if (!among) {
    const auto all = pointsWithin(0, s, rail, rim, wheel.placement, displaced);
    return rollContact(s, rail, rim, law, wheel, displaced, velocity, step, history, railForces, rimForces, points,
                       closed, &all);
  }
  PatchState patch;
  Sums sums;
  if (closed) closed->rail.clear(), closed->rim.clear();
  const auto& placement = wheel.placement;
  std::vector<std::size_t> before;
  before.swap(history.closed);
  for (const auto& [i, j, point] : *among) {
    TouchPoint t;
    if (!evaluatePoint(s, rail, rim, displaced, placement, i, j, point, nearGap, t) || t.penetration <= 0) continue;
    const double pressure = law.normalPenalty * t.penetration, area = s.area[t.point];
    const double railX = railValue(rail, t, velocity, 0);
    const auto [railY, railZ] = railAcross(s, rail, t, velocity);
    const double radius = s.treadRadius[2 * (j - s.firstColumn) + point / 2];
    const double slipAlong = wheel.speed * t.cosine - wheel.angularVelocity * radius + treadAlong(rim, t, velocity) -
                             (t.cosine * railX + t.sine * railZ);
    // Along the tread's own lateral tangent, cos e_y - sin e_r: with the cone the wheel spins on the patch.
    double slipAcross = s.treadCosine * (treadLateral(rim, t, velocity) - railY);
    if (s.treadSine != 0)
      slipAcross -=
          s.treadSine * (wheel.speed * t.sine + treadRadial(rim, t, velocity) - (t.sine * railX - t.cosine * railZ));
    double* traction = &history.traction[2 * t.point];
    double along = traction[0] + law.tangentialPenalty * step * slipAlong;
    double across = traction[1] + law.tangentialPenalty * step * slipAcross;
    const double limit = law.friction * pressure, size = std::hypot(along, across);
    const bool slips = size > limit;
    if (slips) {
      const double back = size > 0 ? limit / size : 0;
      // What the return takes off is slip that friction has worked through.
      patch.frictionPower += area * (1 - back) * size * limit / (law.tangentialPenalty * step);
      along *= back, across *= back;
      ++patch.slipping;
    }
    traction[0] = along, traction[1] = across;
    history.closed.push_back(t.point);
    ++patch.points;
    patch.deepest = std::max(patch.deepest, t.penetration);
    patch.storedEnergy +=
        0.5 * area * (pressure * t.penetration + (along * along + across * across) / law.tangentialPenalty);

    // On the rail, along e_r = (sine, -cosine), e_alpha = (cosine, sine) and y.
    const double outwards = s.treadCosine * pressure - s.treadSine * across;
    const double forceX = area * (outwards * t.sine + along * t.cosine);
    const double forceZ = area * (along * t.sine - outwards * t.cosine);
    const double forceY = area * (s.treadCosine * across + s.treadSine * pressure);
    const double forceB = s.railCosine * forceY + s.railSine * forceZ,
                 forceC = s.railCosine * forceZ - s.railSine * forceY;
    for (int a = 0; a < 2; ++a) {
      const double w0 = t.railWeight[2 * a], w1 = t.railWeight[2 * a + 1];
      const int station = t.railStation;
      addForce(rail, railForces, t.railNode[a], 0, station, station + 1, w0 * forceX, w1 * forceX);
      addForce(rail, railForces, t.railNode[a], 1, station, station + 1, w0 * forceB, w1 * forceB);
      addForce(rail, railForces, t.railNode[a], 2, station, station + 1, w0 * forceC, w1 * forceC);
      const double v0 = t.treadWeight[2 * a], v1 = t.treadWeight[2 * a + 1];
      const int left = t.treadStation[0], right = t.treadStation[1];
      double forceAlong[2], forceRadial[2];  // against those on the rail, in the stations' bases
      for (int side = 0; side < 2; ++side) {
        forceAlong[side] = area * (t.turnSine[side] * outwards - t.turnCosine[side] * along);
        forceRadial[side] = -area * (t.turnSine[side] * along + t.turnCosine[side] * outwards);
      }
      addForce(rim, rimForces, t.treadNode[a], 0, left, right, v0 * forceAlong[0], v1 * forceAlong[1]);
      addForce(rim, rimForces, t.treadNode[a], 1, left, right, v0 * forceRadial[0], v1 * forceRadial[1]);
      addForce(rim, rimForces, t.treadNode[a], 2, left, right, -v0 * forceY, -v1 * forceY);
    }
    for (int a = 0; closed && a < 2; ++a)
      for (int side = 0; side < 2; ++side) {
        closed->rail.push_back({t.railNode[a], t.railStation + side, t.railWeight[2 * a + side] * area});
        closed->rim.push_back({t.treadNode[a], t.treadStation[side], t.treadWeight[2 * a + side] * area});
      }
    patch.vertical -= forceZ, patch.longitudinal += forceX, patch.lateral += forceY;
    patch.rotationMoment += radius * area * (along + outwards * t.lead);
    const double x = s.pointX[t.point] - placement.centreX - placement.hubX, y = s.pointY[t.point], n = pressure * area;
    sums.n += n, sums.x1 += n * x, sums.y1 += n * y, sums.x2 += n * x * x, sums.y2 += n * y * y;
    if (points) points->push_back({x, y, pressure, along, across, area, slips});
  }
  // Points that have opened forget their traction; both lists are in ascending order.
  std::size_t k = 0;
  for (const std::size_t old : before) {
    while (k < history.closed.size() && history.closed[k] < old) ++k;
    if (k == history.closed.size() || history.closed[k] != old)
      history.traction[2 * old] = history.traction[2 * old + 1] = 0;
  }
  if (sums.n > 0) {
    const double meanX = sums.x1 / sums.n, meanY = sums.y1 / sums.n;
    patch.length = 2 * std::sqrt(5 * std::max(0.0, sums.x2 / sums.n - meanX * meanX));
    patch.width = 2 * std::sqrt(5 * std::max(0.0, sums.y2 / sums.n - meanY * meanY));
  }
  return patch;
}

}  // namespace squat::contact
