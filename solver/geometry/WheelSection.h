// solver/geometry/WheelSection.h - sections of the half wheelset in (radius, y), y from the wheel plane, outwards
// positive.
#pragma once

#include "geometry/SectionMesh.h"
#include "scenario/Scenario.h"

namespace squat::geometry {

struct WheelSectionSizes {
  double contactSize = 0, bandHalfWidth = 0, sectionSize = 0, growth = 0;  // as in the rail
  double rimDepth = 0;                                                     // [m]
  double treadSlope = 0;  // [-] by which the tread's radius falls outwards
};

// The finely meshed outer rim: radius - rimDepth .. radius.
SectionMesh rimSectionMesh(const scenario::Wheelset& wheelset, const WheelSectionSizes& sizes);

// Inner rim, web, hub and axle from the symmetry plane to the end of the journal: rectangles on one grid.
SectionMesh wheelBodySectionMesh(const scenario::Wheelset& wheelset, const WheelSectionSizes& sizes);

}  // namespace squat::geometry
