// solver/scenario/DefectSurface.h - the defect as a surface z = h(x, y): every analytic shape and sampled profiles.
// x = 0 is the deepest point (of several equal ones the first), y = 0 the middle of the running surface, heights up.
//
//   cut            linear ramps of length `ramp` at both ends of `length`, flat floor at -depth between them
//   cosine         -depth/2 (1 + cos(2 pi x / length))
//   w-shape        four half cosines of length/4: down to -depth, up to -depth (1 - middleHeight), down, up to zero;
//                  its first bottom is at x = 0
//   dip-with-wave  the cosine dip, behind it waveCount dips -waveDepth/2 (1 - cos(2 pi s / waveLength))
//   profile        through the points of one line or of several side by side (ProfileCurve.h), those of the stretch
//   that
//                  counts, filtered where the defect says so (MeasuredProfile.h); heights are multiplied
//                  by heightScale, positions shifted so that the deepest point of all lines lies at x = 0. With `level`
//                  the line through first and last point of each is taken off; without it ends that are not at zero
//                  run out over 20 mm. Between lines the monotone cubic of the lines' heights at the same x; beyond the
//                  outermost ones as they are.
// Across the rail a single line is uniform, or parabolic 1 - (y / halfWidth)^2, zero beyond. y counts on the crown from
// its middle, outwards; the defect's own y = 0 stands at lateralCentre.
#pragma once

#include <vector>

#include "scenario/Defect.h"
#include "scenario/ProfileCurve.h"

namespace squat::scenario {

class DefectSurface {
 public:
  DefectSurface() : DefectSurface(Defect{}) {}   // a smooth rail
  explicit DefectSurface(const Defect& defect);  // profiles need ascending positions; fewer than two points: no defect

  double height(double x, double y = 0) const;  // [m]; zero outside first() to last()
  double slope(double x, double y = 0) const;   // dh/dx; at a kink of the cut the one behind it

  double first() const { return first_; }  // [m] smallest and largest x where the surface is not plane; 0, 0: no defect
  double last() const { return last_; }
  double depth() const { return depth_; }                    // [m] of the deepest point, positive
  double deepestLateral() const { return deepestLateral_; }  // [m] y of the line that has it
  double dipLength() const { return dipLength_; }  // [m] of the dip around x = 0, between heights of 5 % of its depth
  double steepest() const { return steepest_; }    // largest |dh/dx|
  double profileSpacing() const { return spacing_; }  // [m] largest between points of the dip; 0: analytic

  // Points of the line with the deepest point after levelling and shifting; of an analytic shape 1 mm apart.
  std::vector<ProfilePoint> samples() const;
  // Lateral positions of the lines [m]; empty where there is one only.
  const std::vector<double>& lateralLines() const { return lateral_; }

 private:
  void takeLines();
  void measure();
  std::vector<double> marks(const ProfileCurve* curve) const;
  double crossing(const ProfileCurve* curve, double x, double y, double height) const;
  HeightAndSlope along(const ProfileCurve* curve, double x) const;
  double across(double y) const;
  const ProfileCurve* deepestCurve() const { return curves_.empty() ? nullptr : &curves_[deepestCurve_]; }

  Defect defect_;
  std::vector<ProfileCurve> curves_;  // one a line
  std::vector<double> lateral_;       // of several lines
  std::size_t deepestCurve_ = 0;
  double first_ = 0, last_ = 0, depth_ = 0, deepestLateral_ = 0, dipLength_ = 0, steepest_ = 0, spacing_ = 0;
};

// Height of one point; builds the surface anew, so for many points use DefectSurface.
double defectHeight(const Defect& defect, double x, double y = 0);
// Along y = 0, `step` apart, from `margin` ahead of the first point that is not plane to as far behind the last.
std::vector<double> defectHeights(const Defect& defect, double margin, double step);

// Path of the centre of a rigid wheel that rolls over the line at y, relative to the path on a smooth rail:
// w(x) = max over s of h(x + s) - (radius - sqrt(radius^2 - s^2)), at x = from, from + step, ... up to `to`.
std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, double radius, double from, double to,
                                         double step, double y = 0);

}  // namespace squat::scenario
