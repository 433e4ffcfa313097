#include "contact/TouchPoint.h"

#include <algorithm>
#include <cmath>

#include "core/ElementaryFunctions.h"

namespace squat::contact {

double railValue(const elasticity::SweptBlock& rail, const TouchPoint& t, const double* state, int component) {
  const auto first = rail.line(state, t.railNode[0], component), second = rail.line(state, t.railNode[1], component);
  const int left = t.railStation, right = t.railStation + 1;
  return t.railWeight[0] * first[left] + t.railWeight[1] * first[right] + t.railWeight[2] * second[left] +
         t.railWeight[3] * second[right];
}

namespace {

// The tread's component at the left and the right station, interpolated between its two section nodes.
struct Sides {
  double left, right;
};
Sides treadSides(const elasticity::SweptBlock& rim, const TouchPoint& t, const double* state, int component) {
  const auto first = rim.line(state, t.treadNode[0], component), second = rim.line(state, t.treadNode[1], component);
  return {t.treadWeight[0] * first[t.treadStation[0]] + t.treadWeight[2] * second[t.treadStation[0]],
          t.treadWeight[1] * first[t.treadStation[1]] + t.treadWeight[3] * second[t.treadStation[1]]};
}

// The interval in which an angle lies, looked for from interval k on; the angle is brought among the rim's own.
int intervalAt(const elasticity::SweptBlock& rim, int k, double& angle) {
  constexpr double full = 6.283185307179586;
  if (std::abs(angle) > 4 * full)
    angle = std::remainder(angle, full);  // of a state that diverges: it must end all the same, and soon
  while (angle < rim.positions[k])
    if (k > 0) {
      --k;
    } else {
      angle += full, k = rim.intervals - 1;
    }
  while (angle >= rim.positions[k + 1])
    if (k + 1 < rim.intervals) {
      ++k;
    } else {
      angle -= full, k = 0;
    }
  return k;
}

// Takes the material at an angle, in interval k, with its bases as seen from the touch point, `lead` ahead.
void meet(const Surfaces& s, const elasticity::SweptBlock& rim, int lateral, int k, double angle, double lead,
          TouchPoint& t) {
  const double u = (angle - rim.positions[k]) / (rim.positions[k + 1] - rim.positions[k]);
  const int tread = s.treadColumn[lateral];
  const double v = s.treadFraction[lateral];
  t.treadNode[0] = s.treadLine[tread], t.treadNode[1] = s.treadLine[tread + 1];
  t.treadStation[0] = k, t.treadStation[1] = k + 1 == rim.intervals ? 0 : k + 1;
  t.treadWeight[0] = (1 - v) * (1 - u), t.treadWeight[1] = (1 - v) * u;
  t.treadWeight[2] = v * (1 - u), t.treadWeight[3] = v * u;
  for (int side = 0; side < 2; ++side) {
    // Angles of half an element: the series errs by less than 1e-12.
    const double d = rim.positions[k + side] - angle - lead, d2 = d * d;
    t.turnCosine[side] = 1 - d2 / 2 * (1 - d2 / 12), t.turnSine[side] = d * (1 - d2 / 6 * (1 - d2 / 20));
  }
}

// From the basis at the touch point's angle to that of the tread, whose normal leans back by the tilt.
void lean(double slope, TouchPoint& t) {
  const double size = elementary::hypot(1.0, slope), c = 1 / size, s = slope / size;
  t.tiltCosine = c, t.tiltSine = s;
  const double sine = t.sine, cosine = t.cosine;
  t.sine = sine * c - cosine * s, t.cosine = cosine * c + sine * s;
  for (int side = 0; side < 2; ++side) {
    const double turnCosine = t.turnCosine[side], turnSine = t.turnSine[side];
    t.turnCosine[side] = turnCosine * c - turnSine * s, t.turnSine[side] = turnSine * c + turnCosine * s;
  }
}

}  // namespace

double treadAlong(const elasticity::SweptBlock& rim, const TouchPoint& t, const double* state) {
  const Sides a = treadSides(rim, t, state, 0), r = treadSides(rim, t, state, 1);
  return t.turnCosine[0] * a.left + t.turnSine[0] * r.left + t.turnCosine[1] * a.right + t.turnSine[1] * r.right;
}

double treadRadial(const elasticity::SweptBlock& rim, const TouchPoint& t, const double* state) {
  const Sides a = treadSides(rim, t, state, 0), r = treadSides(rim, t, state, 1);
  return t.turnCosine[0] * r.left - t.turnSine[0] * a.left + t.turnCosine[1] * r.right - t.turnSine[1] * a.right;
}

double treadLateral(const elasticity::SweptBlock& rim, const TouchPoint& t, const double* state) {
  const Sides y = treadSides(rim, t, state, 2);
  return y.left + y.right;
}

RailMotion railAcross(const Surfaces& s, const elasticity::SweptBlock& rail, const TouchPoint& t, const double* state) {
  const double b = railValue(rail, t, state, 1), c = railValue(rail, t, state, 2);
  return {s.railCosine * b - s.railSine * c, s.railSine * b + s.railCosine * c};
}

std::vector<std::pair<std::size_t, double>> penetrationTerms(const Surfaces& s, const elasticity::SweptBlock& rail,
                                                             const elasticity::SweptBlock& rim, const TouchPoint& t) {
  // The wheel's normal in global axes, then in those of the rail.
  const double x = s.treadCosine * t.sine, y = s.treadSine, z = -s.treadCosine * t.cosine;
  const double railWeights[3] = {x, s.railCosine * y + s.railSine * z, s.railCosine * z - s.railSine * y};
  std::vector<std::pair<std::size_t, double>> terms;
  const auto add = [&](std::size_t index, double weight) {
    if (weight != 0) terms.push_back({index, weight});
  };
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      for (int c = 0; c < 3; ++c)
        add(rail.index(t.railNode[a], c, t.railStation + b), -railWeights[c] * t.railWeight[2 * a + b]);
      const double weight = t.treadWeight[2 * a + b];
      add(rim.index(t.treadNode[a], 0, t.treadStation[b]), -t.turnSine[b] * s.treadCosine * weight);
      add(rim.index(t.treadNode[a], 1, t.treadStation[b]), t.turnCosine[b] * s.treadCosine * weight);
      add(rim.index(t.treadNode[a], 2, t.treadStation[b]), s.treadSine * weight);
    }
  return terms;
}

std::pair<int, int> reachableIntervals(const Surfaces& s, const elasticity::SweptBlock& rail, double x, double reach) {
  const auto begin = rail.positions.begin() + s.firstInterval, end = begin + s.intervals + 1;
  int first = static_cast<int>(std::upper_bound(begin, end, x - reach) - rail.positions.begin()) - 1;
  int last = static_cast<int>(std::lower_bound(begin, end, x + reach) - rail.positions.begin());
  first = std::clamp(first, s.firstInterval, s.firstInterval + s.intervals);
  last = std::clamp(last, first, s.firstInterval + s.intervals);
  return {first, last};
}

bool evaluatePoint(const Surfaces& s, const elasticity::SweptBlock& rail, const elasticity::SweptBlock& rim,
                   const double* state, const WheelPlacement& wheel, int interval, int column, int point, double near,
                   TouchPoint& t) {
  t.point = s.pointIndex(interval, column, point);
  const double x0 = s.pointX[t.point] - wheel.centreX - wheel.hubX, z0 = s.height[t.point] - wheel.centreZ - wheel.hubZ;
  const int lateral = 2 * (column - s.firstColumn) + point / 2;
  const double radius = s.treadRadius[lateral];
  // (R^2 - x^2 - z^2) / 2R is the penetration but for terms of its square over 2R.
  if (radius * radius - x0 * x0 - z0 * z0 < -(near + s.treadHighest) * 2 * radius) return false;
  constexpr double gauss = 0.57735026918962576;
  const double along = 0.5 * (1 + (point % 2 ? gauss : -gauss)), across = 0.5 * (1 + (point / 2 ? gauss : -gauss));
  t.railNode[0] = s.railLine[column], t.railNode[1] = s.railLine[column + 1];
  t.railStation = interval;
  t.railWeight[0] = (1 - across) * (1 - along), t.railWeight[1] = (1 - across) * along;
  t.railWeight[2] = across * (1 - along), t.railWeight[3] = across * along;
  const RailMotion moved = railAcross(s, rail, t, state);
  const double dx = x0 + railValue(rail, t, state, 0), dz = z0 + moved.z;
  const double distance = std::sqrt(dx * dx + dz * dz);
  t.sine = dx / distance, t.cosine = -dz / distance;

  // The tread's material: first that whose reference position this is, then that whose displaced position it is.
  // Stations of rail and rim roll on each other, so the search starts next to its end.
  double angle = elementary::asin(t.sine) + wheel.rotation;
  const int start = interval - s.rolledInterval;
  int k = intervalAt(rim, start < 0 || start >= rim.intervals ? 0 : start, angle);
  meet(s, rim, lateral, k, angle, 0, t);
  t.lead = (treadAlong(rim, t, state) - (wheel.hubX * t.cosine + wheel.hubZ * t.sine)) / radius - wheel.turnAhead;
  double material = angle - t.lead;
  k = intervalAt(rim, k, material);
  meet(s, rim, lateral, k, material, t.lead, t);
  const double radial = treadRadial(rim, t, state) - (wheel.hubX * t.sine - wheel.hubZ * t.cosine);
  const double behind = t.lead + wheel.turnAhead;  // at the instant of the displacements
  double depth = radius * (1 - 0.5 * behind * behind) - distance + radial;
  t.radius = radius, t.tiltSine = 0, t.tiltCosine = 1;
  if (!s.treadCurve.empty()) {
    const auto [deviation, slope] = s.treadCurve[lateral].at(material + s.treadAhead);
    t.radius += deviation;
    lean(slope / t.radius, t);
    depth = t.tiltCosine * (depth + deviation);
  }
  t.penetration = s.treadCosine * depth;
  if (s.treadSine != 0) t.penetration += s.treadSine * (treadLateral(rim, t, state) - moved.y);
  return true;
}

}  // namespace squat::contact
