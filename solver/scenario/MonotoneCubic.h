// solver/scenario/MonotoneCubic.h - slope and value of the cubic that is monotone between sampled points.
//
// After Fritsch and Carlson (1980), slopes after Fritsch and Butland (1984), both in journals of SIAM:
// continuous slope, no overshoot, so the deepest point is a measured one.
#pragma once

namespace squat::scenario {

struct HeightAndSlope {
  double height = 0, slope = 0;
};

// Slope at a point between intervals of widths h0, h1 with secants d0, d1: zero at an extremum of the points, so that
// it is one of the curve.
inline double innerSlope(double h0, double h1, double d0, double d1) {
  if (d0 * d1 <= 0) return 0;
  const double w1 = 2 * h1 + h0, w2 = h1 + 2 * h0;
  return (w1 + w2) / (w1 / d0 + w2 / d1);
}

// At s in an interval of width h, from height a and slopeA at its begin to b and slopeB at its end.
inline HeightAndSlope hermite(double s, double h, double a, double b, double slopeA, double slopeB) {
  const double t = s / h, u = 1 - t;
  const double height = u * u * ((1 + 2 * t) * a + t * h * slopeA) + t * t * ((1 + 2 * u) * b - u * h * slopeB);
  const double slope = 6 * t * u * (b - a) / h + u * (1 - 3 * t) * slopeA + t * (1 - 3 * u) * slopeB;
  return {height, slope};
}

}  // namespace squat::scenario
