#include "contact/RollingContact.h"

#include <algorithm>
#include <cmath>

#include "core/ElementaryFunctions.h"

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

struct Slip {
  double along = 0, across = 0;  // [m/s] of the wheel on the rail, along e_alpha and the tread's lateral tangent
};

Slip slipAt(const Surfaces& s, const TouchPoint& t, const elasticity::SweptBlock& rail,
            const elasticity::SweptBlock& rim, const WheelRolling& wheel, const double* velocity) {
  const double railX = railValue(rail, t, velocity, 0);
  const auto [railY, railZ] = railAcross(s, rail, t, velocity);
  Slip slip;
  slip.along = wheel.speed * t.cosine - wheel.angularVelocity * t.radius * t.tiltCosine + treadAlong(rim, t, velocity) -
               (t.cosine * railX + t.sine * railZ);
  // Along the tread's own lateral tangent, cos e_y - sin e_r: with the cone the wheel spins on the patch.
  slip.across = s.treadCosine * (treadLateral(rim, t, velocity) - railY);
  if (s.treadSine != 0)
    slip.across -= s.treadSine * (wheel.speed * t.sine + wheel.angularVelocity * t.radius * t.tiltSine +
                                  treadRadial(rim, t, velocity) - (t.sine * railX - t.cosine * railZ));
  return slip;
}

// Of a point on the rail, along e_r = (sine, -cosine), e_alpha = (cosine, sine) and y.
struct PointForce {
  double outwards = 0, along = 0;  // [Pa] in the turning basis
  double x = 0, y = 0, z = 0;      // [N]
};

PointForce forceOf(const Surfaces& s, const TouchPoint& t, double area, double pressure, double along, double across) {
  PointForce force;
  force.along = along;
  force.outwards = s.treadCosine * pressure - s.treadSine * across;
  force.x = area * (force.outwards * t.sine + along * t.cosine);
  force.z = area * (along * t.sine - force.outwards * t.cosine);
  force.y = area * (s.treadCosine * across + s.treadSine * pressure);
  return force;
}

void addToRail(const Surfaces& s, const elasticity::SweptBlock& rail, const TouchPoint& t, const PointForce& force,
               const ForceLines& to) {
  const double forceB = s.railCosine * force.y + s.railSine * force.z,
               forceC = s.railCosine * force.z - s.railSine * force.y;
  for (int a = 0; a < 2; ++a) {
    const double w0 = t.railWeight[2 * a], w1 = t.railWeight[2 * a + 1];
    const int station = t.railStation;
    addForce(rail, to, t.railNode[a], 0, station, station + 1, w0 * force.x, w1 * force.x);
    addForce(rail, to, t.railNode[a], 1, station, station + 1, w0 * forceB, w1 * forceB);
    addForce(rail, to, t.railNode[a], 2, station, station + 1, w0 * forceC, w1 * forceC);
  }
}

// Against the force on the rail, in the bases of the two stations.
void addToRim(const elasticity::SweptBlock& rim, const TouchPoint& t, double area, const PointForce& force,
              const ForceLines& to) {
  double along[2], radial[2];
  for (int side = 0; side < 2; ++side) {
    along[side] = area * (t.turnSine[side] * force.outwards - t.turnCosine[side] * force.along);
    radial[side] = -area * (t.turnSine[side] * force.along + t.turnCosine[side] * force.outwards);
  }
  const int left = t.treadStation[0], right = t.treadStation[1];
  for (int a = 0; a < 2; ++a) {
    const double v0 = t.treadWeight[2 * a], v1 = t.treadWeight[2 * a + 1];
    addForce(rim, to, t.treadNode[a], 0, left, right, v0 * along[0], v1 * along[1]);
    addForce(rim, to, t.treadNode[a], 1, left, right, v0 * radial[0], v1 * radial[1]);
    addForce(rim, to, t.treadNode[a], 2, left, right, -v0 * force.y, -v1 * force.y);
  }
}

void addShares(const TouchPoint& t, double area, ClosedArea& closed) {
  for (int a = 0; a < 2; ++a)
    for (int side = 0; side < 2; ++side) {
      closed.rail.push_back({t.railNode[a], t.railStation + side, t.railWeight[2 * a + side] * area});
      closed.rim.push_back({t.treadNode[a], t.treadStation[side], t.treadWeight[2 * a + side] * area});
    }
}

// Points that have opened forget their traction; both lists are in ascending order.
void forgetOpened(const std::vector<std::size_t>& before, FrictionHistory& history) {
  std::size_t k = 0;
  for (const std::size_t old : before) {
    while (k < history.closed.size() && history.closed[k] < old) ++k;
    if (k == history.closed.size() || history.closed[k] != old)
      history.traction[2 * old] = history.traction[2 * old + 1] = 0;
  }
}

void setAxes(const Sums& sums, PatchState& patch) {
  if (!(sums.n > 0)) return;
  const double meanX = sums.x1 / sums.n, meanY = sums.y1 / sums.n;
  patch.length = 2 * std::sqrt(5 * std::max(0.0, sums.x2 / sums.n - meanX * meanX));
  patch.width = 2 * std::sqrt(5 * std::max(0.0, sums.y2 / sums.n - meanY * meanY));
}

}  // namespace

std::vector<RailPoint> pointsWithin(double margin, const ContactPair& pair, const WheelPlacement& wheel,
                                    const double* displaced) {
  const auto& s = pair.surfaces;
  std::vector<RailPoint> found;
  TouchPoint t;
  const auto [first, last] = reachableIntervals(s, pair.rail, wheel.centreX + wheel.hubX, s.reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point)
        if (evaluatePoint(s, pair.rail, pair.rim, displaced, wheel, i, j, point, nearGap, t) && t.penetration > -margin)
          found.push_back({i, j, point});
  return found;
}

PatchState rollContact(const ContactPair& pair, const ContactMotion& motion, FrictionHistory& history,
                       const ContactForces& forces, const ContactScope& scope) {
  if (!scope.among) {
    const auto all = pointsWithin(0, pair, motion.wheel.placement, motion.displaced);
    return rollContact(pair, motion, history, forces, {&all, scope.points, scope.closed});
  }
  const auto& [s, rail, rim, law] = pair;
  const auto& [wheel, displaced, velocity, step] = motion;
  auto* points = scope.points;
  auto* closed = scope.closed;
  PatchState patch;
  Sums sums;
  if (closed) closed->rail.clear(), closed->rim.clear();
  const auto& placement = wheel.placement;
  std::vector<std::size_t> before;
  before.swap(history.closed);
  for (const auto& [i, j, point] : *scope.among) {
    TouchPoint t;
    if (!evaluatePoint(s, rail, rim, displaced, placement, i, j, point, nearGap, t) || t.penetration <= 0) continue;
    const double pressure = law.normalPenalty * t.penetration, area = s.area[t.point];
    const Slip slip = slipAt(s, t, rail, rim, wheel, velocity);
    double* traction = &history.traction[2 * t.point];
    double along = traction[0] + law.tangentialPenalty * step * slip.along;
    double across = traction[1] + law.tangentialPenalty * step * slip.across;
    const double limit = law.friction * pressure, size = elementary::hypot(along, across);
    const bool slips = size > limit;
    if (slips) {
      const double back = size > 0 ? limit / size : 0;
      // What the return takes off is slip that friction has worked through.
      const double power = (1 - back) * size * limit / (law.tangentialPenalty * step);  // [W/m2]
      patch.frictionPower += area * power;
      if (!history.worn.empty() && wheel.speed > 0)
        history.worn[t.point] += wheel.speed * step * wearDepth(law.wear, power / wheel.speed);
      along *= back, across *= back;
      ++patch.slipping;
    }
    traction[0] = along, traction[1] = across;
    history.closed.push_back(t.point);
    ++patch.points;
    patch.deepest = std::max(patch.deepest, t.penetration);
    patch.storedEnergy +=
        0.5 * area * (pressure * t.penetration + (along * along + across * across) / law.tangentialPenalty);

    const PointForce force = forceOf(s, t, area, pressure, along, across);
    addToRail(s, rail, t, force, forces.rail);
    addToRim(rim, t, area, force, forces.rim);
    if (closed) addShares(t, area, *closed);
    patch.vertical -= force.z, patch.longitudinal += force.x, patch.lateral += force.y;
    patch.rotationMoment += t.radius * area * (along * t.tiltCosine + force.outwards * (t.lead - t.tiltSine));
    const double x = s.pointX[t.point] - placement.centreX - placement.hubX, y = s.pointY[t.point], n = pressure * area;
    sums.n += n, sums.x1 += n * x, sums.y1 += n * y, sums.x2 += n * x * x, sums.y2 += n * y * y;
    if (points) points->push_back({x, y, pressure, along, across, area, slips});
  }
  forgetOpened(before, history);
  setAxes(sums, patch);
  return patch;
}

}  // namespace squat::contact
