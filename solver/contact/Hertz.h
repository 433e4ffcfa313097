// solver/contact/Hertz.h - Hertz's elliptic contact of two bodies of one material, for comparison.
#pragma once

namespace squat::contact {

struct HertzContact {
  double halfAxisX = 0, halfAxisY = 0;  // [m]
  double peakPressure = 0;              // [Pa]
  double approach = 0;                  // [m]
};

// radiusX, radiusY: relative radii of curvature along x and y [m]; load [N]. After K. L. Johnson, Contact Mechanics
// (1985), section 4.2, with complete elliptic integrals by the arithmetic-geometric mean.
HertzContact hertzContact(double radiusX, double radiusY, double young, double poisson, double load);

}  // namespace squat::contact
