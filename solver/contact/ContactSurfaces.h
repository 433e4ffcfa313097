// solver/contact/ContactSurfaces.h - the two structured surfaces that roll on each other, and the rail's contact
// points.
#pragma once

#include <cstdint>
#include <vector>

#include "case/CaseDescription.h"
#include "elasticity/SweptBlock.h"

namespace squat::contact {

// The running surface of the rail and the tread of the wheel: lines of section nodes ordered by y. Contact points are
// the 2x2 Gauss points of the rail's faces in the rolled stretch; analytic crown, profile of the defect and tread are
// added to the interpolated nodal displacement.
struct Surfaces {
  int railBlock = -1, rimBlock = -1;
  std::vector<int> railLine, treadLine;  // section nodes
  std::vector<double> railY, treadY;     // [m]
  int firstColumn = 0, columns = 0;      // rail columns (faces between railLine[j], railLine[j + 1]) that can touch
  int firstInterval = 0, intervals = 0;  // rail intervals that can be rolled over
  int rolledInterval = 0;                // rail interval that the rim's interval 0 rolls on
  double radius = 0;                     // [m] of the wheel at the tread

  // Per contact point, ordered [interval][column][point 0..3]: reference height of the rail with the defect, area.
  std::vector<double> height, area, pointX, pointY;
  std::vector<int> treadColumn;  // per column and lateral Gauss point
  std::vector<double> treadFraction;

  std::size_t pointIndex(int interval, int column, int point) const {
    return (static_cast<std::size_t>(interval - firstInterval) * columns + (column - firstColumn)) * 4 + point;
  }
  std::size_t points() const { return height.size(); }
};

Surfaces makeSurfaces(const elasticity::SweptBlock& rail, int railBlock, const elasticity::SweptBlock& rim,
                      int rimBlock, const cases::CaseDescription& description, double from, double to);

}  // namespace squat::contact
