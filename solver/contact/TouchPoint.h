// solver/contact/TouchPoint.h - where a contact point of the rail meets the wheel, and how deep.
#pragma once

#include <utility>
#include <vector>

#include "contact/ContactSurfaces.h"
#include "elasticity/SweptBlock.h"

namespace squat::contact {

// The wheel as the contact sees it: where its reference stands, how far it has turned, and the mean displacement of its
// centre, all in the plane of rolling.
struct WheelPlacement {
  double centreX = 0, centreZ = 0;  // [m] reference position of the axis
  double rotation = 0;              // [rad] since the start, rolling in +x positive
  double hubX = 0, hubZ = 0;        // [m] mean displacement of the wheel centre relative to that
  double turnAhead = 0;             // [rad] from the rotation in whose bases displacements are given to their instant
};

// Penetration, the gap's negative (positive: overlap):
//   delta = R cos lead - |d - u_hub| + (u_wheel - u_hub) . e_r,   d: rail point, displaced, seen from the reference of
// the axis, R the tread's radius there; along the normal n = cos e_r + sin e_y of a conical tread
//   delta_n = cos delta + sin (u_wheel - u_rail) . e_y.
// u_wheel is that of the material whose displaced position is the rail's point. Its reference position lies behind by
//   lead = (u_wheel - u_hub) . e_alpha / R:
// some micrometres of tread, but times load and speed a hundred watts. Seen in the bases of the wheel's rotation, which
// are those of `turnAhead` before, it lies so much less behind: TouchPoint::lead. The pressure acts along n: the slope
// that the displaced tread has against its circle is left out, whose power with the slip is some 15 W of a driven
// wheel's 800 kW (measured).
//
// A tread that is not round has R + r there, r(a) its deviation at the material's angle a, and an outward normal that
// leans against e_alpha by the tilt, tan tilt = r'(a) / (R + r). The touch point's basis is that of the tread: its
// sine and cosine belong to the angle of the normal, and the penetration is taken along it, cos tilt times the radial
// one. What is left out is of the second order in the tilt: 0.4 % of the penetration at the slope of 0.09 of a deep
// flat. The rim's mesh stays round. Neither a rotation of the wheel's displacement field about the axle nor a
// translation is felt but for where it takes the material.
struct TouchPoint {
  std::size_t point = 0;
  double penetration = 0;
  double sine = 0, cosine = 1;  // of the spatial angle: e_r = (sine, -cosine), e_alpha = (cosine, sine) in (x, z);
                                // where the tread is not round, of its normal's
  int railNode[2] = {0, 0}, railStation = 0;
  double railWeight[4] = {0, 0, 0, 0};  // node 0: station, station + 1; node 1: the same
  int treadNode[2] = {0, 0}, treadStation[2] = {0, 0};
  double treadWeight[4] = {0, 0, 0, 0};  // node 0: left, right station; node 1: the same
  double lead = 0;                       // [rad] see above
  double radius = 0;                     // [m] of the tread's material
  double tiltSine = 0, tiltCosine = 1;   // see above
  // Cosine and sine of the angle from the touch point to the left and the right station: local bases differ.
  double turnCosine[2] = {1, 1}, turnSine[2] = {0, 0};
};

// Sets penetration to the gap's negative; everything else is only filled in where the undeformed gap is below `near`.
// Returns false for points that are farther away than that.
bool evaluatePoint(const Surfaces& surfaces, const elasticity::SweptBlock& rail, const elasticity::SweptBlock& rim,
                   const double* state, const WheelPlacement& wheel, int interval, int column, int point, double near,
                   TouchPoint& touch);

// Rail intervals [first, second) within reach of a wheel at x.
std::pair<int, int> reachableIntervals(const Surfaces& surfaces, const elasticity::SweptBlock& rail, double x,
                                       double reach);

// Displacement of the rail's point along y and z, its local components turned by the rail's lean.
struct RailMotion {
  double y = 0, z = 0;
};
RailMotion railAcross(const Surfaces& surfaces, const elasticity::SweptBlock& rail, const TouchPoint& touch,
                      const double* state);

// The penetration's derivative, but for the tread's slope, as terms (state index, weight): what a spring between the
// two surfaces acts on.
std::vector<std::pair<std::size_t, double>> penetrationTerms(const Surfaces& surfaces,
                                                             const elasticity::SweptBlock& rail,
                                                             const elasticity::SweptBlock& rim,
                                                             const TouchPoint& touch);

// Interpolated state at the touch point: a component of the rail, and the tread's along e_alpha, e_r and y.
double railValue(const elasticity::SweptBlock& rail, const TouchPoint& touch, const double* state, int component);
double treadAlong(const elasticity::SweptBlock& rim, const TouchPoint& touch, const double* state);
double treadRadial(const elasticity::SweptBlock& rim, const TouchPoint& touch, const double* state);
double treadLateral(const elasticity::SweptBlock& rim, const TouchPoint& touch, const double* state);

}  // namespace squat::contact
