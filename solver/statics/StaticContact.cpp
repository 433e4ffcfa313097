#include "statics/StaticContact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/TouchPoint.h"
#include "model/ContactPenalty.h"

namespace squat::statics {

namespace {

constexpr double patchReach = 0.022;  // [m] along the rail, far beyond any patch
constexpr double nearGap = 1.2e-3;    // [m] undeformed gap that a deflection of the track may close

}  // namespace

ClosedContact evaluateContact(const model::Model& model, const model::TurnedStations& turned, const double* u,
                              double wheelX, double rotation) {
  const auto& s = model.surfaces;
  const double penalty = model::normalPenalty(model.scenario);
  const auto &rail = model.blocks[model.rail], &rim = model.blocks[model.rim];
  const auto hub = ringMean(model, model.centre, turned, u);
  const contact::WheelPlacement wheel{wheelX, model.wheelset.centreHeight, rotation, hub.x, hub.z};
  ClosedContact closed;
  // A wheel that is not round may stand on two places with nothing between them.
  const double reach = s.treadCurve.empty() ? patchReach : std::max(patchReach, s.reach);
  const auto [first, last] = contact::reachableIntervals(s, rail, wheelX, reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        contact::TouchPoint t;
        if (!evaluatePoint(s, rail, rim, u, wheel, i, j, point, nearGap, t) || t.penetration <= 0) continue;
        closed.springs.add(contact::penetrationTerms(s, rail, rim, t), penalty * s.area[t.point], 0);
        closed.penetration.push_back(t.penetration);
        closed.location.push_back({s.pointX[t.point] - wheelX, s.pointY[t.point]});
        const double force = penalty * s.area[t.point] * t.penetration;
        closed.vertical += force * s.treadCosine * t.cosine;
        closed.lateral += force * s.treadSine;
      }
  return closed;
}

double rigidOverlap(const model::Model& model, double wheelX, double rotation) {
  const auto& s = model.surfaces;
  if (s.treadCurve.empty()) return 0;
  const auto &rail = model.blocks[model.rail], &rim = model.blocks[model.rim];
  const AlignedVector rest(model.stateSize, 0.0);
  const contact::WheelPlacement wheel{wheelX, model.wheelset.centreHeight, rotation, 0, 0};
  double largest = -1;  // [m]
  const auto [first, last] = contact::reachableIntervals(s, rail, wheelX, s.reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        contact::TouchPoint t;
        constexpr double anywhere = 0.1;  // [m]
        if (!evaluatePoint(s, rail, rim, rest.data(), wheel, i, j, point, anywhere, t)) continue;
        largest = std::max(largest, t.penetration / (s.treadCosine * t.cosine));
      }
  return largest;
}

void addContactForces(const ClosedContact& closed, double* r) {
  for (std::size_t i = 0; i < closed.springs.size(); ++i) {
    const double force = closed.springs.stiffness[i] * closed.penetration[i];
    for (std::size_t t = closed.springs.start[i]; t < closed.springs.start[i + 1]; ++t)
      r[closed.springs.unknown[t]] -= closed.springs.weight[t] * force;
  }
}

double storedEnergy(const ClosedContact& closed) {
  double sum = 0;
  for (std::size_t i = 0; i < closed.springs.size(); ++i)
    sum += 0.5 * closed.springs.stiffness[i] * closed.penetration[i] * closed.penetration[i];
  return sum;
}

void describePatch(const ClosedContact& closed, Equilibrium& e) {
  double n = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  for (std::size_t i = 0; i < closed.springs.size(); ++i) {
    const double force = closed.springs.stiffness[i] * closed.penetration[i];
    n += force;
    x1 += force * closed.location[i][0], y1 += force * closed.location[i][1];
    x2 += force * closed.location[i][0] * closed.location[i][0],
        y2 += force * closed.location[i][1] * closed.location[i][1];
  }
  e.halfAxisRolling = std::sqrt(5 * std::max(0.0, x2 / n - x1 * x1 / n / n));
  e.halfAxisLateral = std::sqrt(5 * std::max(0.0, y2 / n - y1 * y1 / n / n));
  e.centreLateral = y1 / n;
  const double axes = e.halfAxisRolling * e.halfAxisLateral;  // 0 where the points stand in one line
  e.peakPressure = axes > 0 ? 3 * n / (2 * std::numbers::pi * axes) : 0;
}

}  // namespace squat::statics
