// solver/scenario/ProfileCurve.h - a smooth curve through sampled heights, as defects are made of.
//
// Piecewise cubic that is monotone between the points (MonotoneCubic.h).
#pragma once

#include <vector>

#include "scenario/Defect.h"
#include "scenario/MonotoneCubic.h"

namespace squat::scenario {

class ProfileCurve {
 public:
  // Heights times `scale`. With `level` the line through first and last point is taken off; without it ends that are
  // not at zero run out over 20 mm. Positions ascend; fewer than two points: no curve.
  ProfileCurve(const std::vector<ProfilePoint>& points, double scale, bool level);

  // The lowest point; of several equal ones the first. {0, 0} where there is no curve.
  ProfilePoint deepest() const;
  // Shifts the curve by -origin and trims flat lead-in and run-out, which are no part of the defect.
  void finish(double origin);

  bool empty() const { return nodes_.empty(); }
  double first() const { return nodes_.front().position; }
  double last() const { return nodes_.back().position; }
  HeightAndSlope at(double x) const;  // zero outside first() to last()
  std::vector<ProfilePoint> points() const;

 private:
  struct Node {
    double position, height, slope;
  };
  void level(bool ends);
  void trim();
  void findSlopes();
  std::vector<Node> nodes_;
};

// The same cubic across the rail: value at y from values at ascending places; constant beyond the outermost.
double monotoneBetween(const std::vector<double>& positions, const std::vector<double>& values, double y);

}  // namespace squat::scenario
