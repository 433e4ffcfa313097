// core/ElementaryFunctions.h - sines, exponentials and roots with the same bits on every system.
//
// The standard promises the last bit of a sum, a product and a square root, but not of std::sin(): it differs between
// Linux and Windows, and on Linux between processors with and without fused multiplication. A run carries such a bit
// on: after 30 ms of rolling on `tiny`, accelerations differed by 1e-5 of their peaks. What moves wheel, track and
// contact therefore calls these, which are made of sums, products and square roots alone.
//
// Errors are at most 1 unit in the last place for sin, cos, asin, exp and cbrt, and at most 3 for the others.
#pragma once

namespace squat::elementary {

// Angles in rad, up to 1e6; 1 unit in the last place also beside the zeros.
double sin(double x);
double cos(double x);
double tan(double x);

double asin(double x);  // of -1 to 1
double acos(double x);  // of -1 to 1
double atan(double x);
double atan2(double y, double x);  // from -pi to pi

double exp(double x);
double cbrt(double x);

double hypot(double x, double y);  // of lengths from 1e-150 to 1e150: squares are neither too large nor too small

}  // namespace squat::elementary
