// solver/case/DefectSurface.h - the defect as a surface z = h(x, y): every analytic shape and sampled profiles.
// x = 0 is the deepest point (of several equal ones the first), y = 0 the middle of the running surface, heights up.
//
//   cut            linear ramps of length `ramp` at both ends of `length`, flat floor at -depth between them
//   cosine         -depth/2 (1 + cos(2 pi x / length))
//   w-shape        four half cosines of length/4: down to -depth, up to -depth (1 - middleHeight), down, up to zero;
//                  its first bottom is at x = 0
//   dip-with-wave  the cosine dip, behind it waveCount dips -waveDepth/2 (1 - cos(2 pi s / waveLength))
//   profile        through the points: piecewise cubic that is monotone between points (Fritsch and Carlson, SIAM J.
//                  Numer. Anal. 17, 1980; slopes after Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984), so it
//                  has a continuous slope and no overshoot: the deepest point is a measured one. Heights are multiplied
//                  by heightScale; positions are shifted
//                  so that it lies at x = 0. With `level` the line through first and last point is taken off; without
//                  it ends that are not at zero run out over 20 mm.
// Across the rail: uniform, or parabolic 1 - (y / halfWidth)^2, zero beyond.
#pragma once

#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

class DefectSurface {
 public:
  explicit DefectSurface(const Defect& defect);  // profiles need ascending positions; fewer than two points: no defect

  double height(double x, double y = 0) const;  // [m]; zero outside first() to last()
  double slope(double x, double y = 0) const;   // dh/dx; at a kink of the cut the one behind it

  double first() const { return first_; }  // [m] smallest and largest x where the surface is not plane; 0, 0: no defect
  double last() const { return last_; }
  double depth() const { return depth_; }          // [m] of the deepest point, positive
  double dipLength() const { return dipLength_; }  // [m] of the dip around x = 0, between heights of 5 % of its depth
  double steepest() const { return steepest_; }    // largest |dh/dx|
  double profileSpacing() const { return spacing_; }  // [m] largest between points of the dip; 0: analytic

  // Points of a profile after levelling and shifting; of an analytic shape 1 mm apart. For figures.
  std::vector<ProfilePoint> samples() const;

 private:
  struct Node {
    double position, height, slope;
  };
  void takeProfile();
  void level();
  void findSlopes();
  void trim();
  void measure();
  std::vector<double> marks() const;
  double alongHeight(double x) const;
  double alongSlope(double x) const;
  double across(double y) const;

  Defect defect_;
  std::vector<Node> nodes_;
  double first_ = 0, last_ = 0, depth_ = 0, dipLength_ = 0, steepest_ = 0, spacing_ = 0;
};

// Height of one point; builds the surface anew, so for many points use DefectSurface.
double defectHeight(const Defect& defect, double x, double y = 0);

// Path of the centre of a rigid wheel that rolls over the middle line, relative to the path on a smooth rail:
// w(x) = max over s of h(x + s) - (radius - sqrt(radius^2 - s^2)), at x = from, from + step, ... up to `to`.
std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, double radius, double from, double to,
                                         double step);

}  // namespace squat::cases
