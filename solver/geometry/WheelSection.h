// solver/geometry/WheelSection.h - sections of the half wheelset in (radius, y), y from the wheel plane, outwards
// positive.
#pragma once

#include "geometry/SectionMesh.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::geometry {

struct WheelSectionSizes {
  double contactSize = 0, bandHalfWidth = 0, sectionSize = 0, growth = 0;  // as in the rail
  double rimDepth = 0;                                                     // [m]
  double treadSlope = 0;  // [-] by which the tread's radius falls outwards
};

// The finely meshed outer rim: radius - rimDepth .. radius.
SectionMesh rimSectionMesh(const scenario::Wheelset& wheelset, const WheelSectionSizes& sizes);

// Radius of the line of nodes nearest to the wheel seat: hub and seat are one solid, so that it only divides it. At
// y = 0 its motion is that of the wheel's centre.
double seatLineRadius(const scenario::Wheelset& wheelset);

// Inner rim, web, hub and axle from the symmetry plane to the end of the journal. Details below 12 mm (steps of radii,
// a shoulder, the hub beside the web) are tapered or left out; a bore below 0.3 of the thinnest radius and 25 mm is
// meshed that wide.
SectionMesh wheelBodySectionMesh(const scenario::Wheelset& wheelset, const WheelSectionSizes& sizes);

}  // namespace squat::geometry
