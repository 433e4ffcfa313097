// solver/contact/ContactSurfaces.h - the two structured surfaces that roll on each other, and the rail's contact
// points.
#pragma once

#include <cstdint>
#include <vector>

#include "elasticity/SweptBlock.h"
#include "scenario/ScenarioDeclaration.h"
#include "scenario/TreadCurve.h"

namespace squat::contact {

// The running surface of the rail and the tread of the wheel: lines of section nodes ordered by y. Contact points are
// the 2x2 Gauss points of the rail's faces in the rolled stretch; analytic crown, profile of the defect and tread are
// added to the interpolated nodal displacement.
struct Surfaces {
  int railBlock = -1, rimBlock = -1;
  scenario::RailSection section{};        // of the rail
  std::vector<int> railLine, treadLine;   // section nodes
  std::vector<double> railY, treadY;      // [m]
  int firstColumn = 0, columns = 0;       // rail columns (faces between railLine[j], railLine[j + 1]) that can touch
  int firstInterval = 0, intervals = 0;   // rail intervals that can be rolled over
  int rolledInterval = 0;                 // rail interval that the rim's interval 0 rolls on
  double radius = 0;                      // [m] of the wheel where it touches
  double crownRadius = 0;                 // [m] of the rail across, there
  double reach = 0;                       // [m] along the rail from below the axis: contact is looked for within
  double touchY = 0;                      // [m] where the wheel touches, along the crown from its middle outwards
  double railCosine = 1, railSine = 0;    // of the rail's lean: its b is (0, cosine, sine), its c (0, -sine, cosine)
  double treadCosine = 1, treadSine = 0;  // of the tread's slope: its normal is cosine e_r + sine e_y

  // Per contact point, ordered [interval][column][point 0..3]: reference height of the rail with the defect, area,
  // place, all in global axes.
  std::vector<double> height, area, pointX, pointY;
  std::vector<int> treadColumn;  // per column and lateral Gauss point
  std::vector<double> treadFraction, treadRadius;
  // A tread that is not round: its deviation for each of those; none: round. Curves count from the deviation's deepest
  // point, which stands `treadAhead` [rad] before the material below the axis of a wheel that has not turned yet.
  std::vector<scenario::TreadCurve> treadCurve;
  double treadAhead = 0, treadHighest = 0, treadSteepest = 0;  // [rad], [m], [-]

  std::size_t pointIndex(int interval, int column, int point) const {
    return (static_cast<std::size_t>(interval - firstInterval) * columns + (column - firstColumn)) * 4 + point;
  }
  std::size_t points() const { return height.size(); }
};

// How the wheel stands on the rail. A crown and a straight tread touch where their slopes agree, so the tread's slope
// at its running circle decides; that circle stands over motion.lateral_offset of the crown, and the slope there is the
// cone's plus what the crown's own changes from its middle: a tread that is worn to the rail.
struct WheelSeat {
  double lean = 0;          // [rad] of the rail, its head towards -y
  double treadSlope = 0;    // [-]
  double touchY = 0;        // [m] along the crown, from its middle outwards
  double wheelY = 0;        // [m] global y of the running circle
  double centreHeight = 0;  // [m] of the axis above the middle of the running surface
  double radius = 0;        // [m] of the wheel where it touches
  double crownRadius = 0;   // [m] of the rail across, there
};
// Throws CaseError where they touch beyond the arcs of the crown.
WheelSeat seatOf(const scenario::Scenario& scenario);

// Faces of a running line at `railY` that a wheel can press which touches at `y` [m].
struct Columns {
  int first = 0, count = 0;
};
Columns touchedColumns(const std::vector<double>& railY, double y);

// Section nodes of the rail on R300 and R80 of its crown, ascending in y.
std::vector<int> runningLine(const elasticity::SweptBlock& rail, scenario::RailSection section);

// Gives surfaces, which have all but their contact points, defect and irregularity of a scenario: their reach, heights,
// areas and places.
void layDefect(Surfaces& surfaces, const elasticity::SweptBlock& rail, const scenario::Scenario& scenario);

// Surfaces::reach [m] for a wheel that touches with this radius [m].
double reachAlong(const scenario::Scenario& scenario, double radius);

Surfaces makeSurfaces(const elasticity::SweptBlock& rail, int railBlock, const elasticity::SweptBlock& rim,
                      int rimBlock, const scenario::Scenario& scenario, double from, double to);

}  // namespace squat::contact
