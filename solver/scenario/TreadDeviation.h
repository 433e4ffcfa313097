// solver/scenario/TreadDeviation.h - a wheel that is not round: radial deviation of its tread over one turn, such as a
// flat, a worn polygon or an eccentric tread.
//
// The tread's material at the angle a, counted from the deepest point (of several equal ones the first) in the order in
// which the material meets the rail, has the radius R(y) + d(a, y); d is negative where material is missing. One line
// is the same all across the tread; between several side by side the monotone cubic of their deviations, beyond the
// outermost ones as they are. A table that leaves more than 40 mm of the turn open is round there: ends that are not at
// zero run out over 20 mm. Smaller gaps are closed by the curve.
#pragma once

#include <string>
#include <vector>

#include "scenario/Defect.h"
#include "scenario/DefectSurface.h"
#include "scenario/TreadCurve.h"

namespace squat::scenario {

// As a user writes it. Positions are lengths of arc on the nominal radius, in the order in which the tread meets the
// rail; `height` is the deviation, outwards positive.
struct TreadShape {
  std::string file;                  // path of the table as the case names it
  std::vector<ProfilePoint> points;  // the table as read
  std::vector<ProfileLine> lines;    // several lines side by side, `lateral` from the wheel plane outwards; they count
                                     // before points
  double position = 0;               // [m] along the track where the deepest point meets the rail
  bool isRound() const { return points.empty() && lines.empty(); }
};

class TreadDeviation {
 public:
  TreadDeviation() = default;                              // a round wheel
  TreadDeviation(const TreadShape& shape, double radius);  // [m] nominal; fewer than two points: round

  bool isRound() const { return curves_.empty(); }
  // The curve at a lateral position [m]; its angle zero is the deepest point.
  TreadCurve curveAt(double y) const;

  double position() const { return position_; }  // [m] along the track where the deepest point meets the rail
  double lowest() const { return lowest_; }      // [m] of all lines
  double highest() const { return highest_; }
  double steepest() const { return steepest_; }  // [-] largest |dr/ds|
  double spacing() const { return spacing_; }    // [m] largest between points of the dip
  // Ends of the dip about the deepest point, where 95 % of lowest to highest are regained: lengths of arc from there.
  double dipBefore() const { return dipBefore_; }
  double dipBehind() const { return dipBehind_; }
  // Whether that is one place of the tread, such as a flat: shorter than 0.3 m, and nothing half as deep elsewhere.
  bool isLocal() const { return isLocal_; }
  // [m] from below the axis beyond which a wheel of this radius with this tread does not touch a plane rail: where the
  // tangent is level, x = R dr/ds, and never farther down than the deviation varies, x^2/2R.
  double touchReach(double radius) const;
  // Angle [rad] from the deepest point to the material below the axis of a wheel at x that rolls freely.
  double angleAt(double x, double rollingRadius) const { return (x - position_) / rollingRadius; }

 private:
  void measure(double radius);
  std::vector<TreadCurve> curves_;  // one a line
  std::vector<double> lateral_;     // of several lines
  std::size_t deepestCurve_ = 0;
  bool isLocal_ = false;
  double position_ = 0, lowest_ = 0, highest_ = 0, steepest_ = 0, spacing_ = 0, dipBefore_ = 0, dipBehind_ = 0;
};

// Path of the axis of a rigid wheel, as DefectSurface.h's rigidWheelPath, with the tread's deviation at the lateral
// position `treadY`: w(x) = max over s of h(x + s) + sqrt((R + d)^2 - s^2) - R.
std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, const TreadDeviation& tread, double radius,
                                         double from, double to, double step, double y = 0, double treadY = 0);

}  // namespace squat::scenario
