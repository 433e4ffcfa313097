// solver/geometry/RailSection.h - the true section of a 54E1 rail and its mesh.
#pragma once

#include "geometry/SectionMesh.h"

namespace squat::geometry {

// Right half of the outline (y >= 0), z = 0 on the running surface, up positive [m]. Head after EN 13674-1 (R300, R80,
// R13, side 1:20, underside 1:2.75); web R508 and fillets R7 and R20 fitted to the published area, centroid and
// moments.
struct RailOutline {
  std::vector<Point2> crown;      // middle of the running surface to the middle of the R13 arc
  std::vector<Point2> headSide;   // from there to the lower corner of the head
  std::vector<Point2> underside;  // from the middle of the head-web fillet to the lower corner
  std::vector<Point2> web;        // from the middle of the head-web fillet to the middle of the web-foot fillet
  std::vector<Point2> footTop;    // from there to the upper edge of the foot
  double height = 0, footHalfWidth = 0, footEdge = 0;
};
RailOutline outline54E1();

// Height of the crown z(y) [m] and its slope, |y| within R300 and R80; R13 is not reached by a wheel that rolls
// centrally.
double crownHeight54E1(double y);
double crownSlope54E1(double y);

struct RailSectionSizes {
  double contactSize = 0;    // [m] quads in the contact band
  double bandHalfWidth = 0;  // [m]
  double sectionSize = 0;    // [m] largest quads
  double growth = 0;         // [-] of neighbouring quads away from the band
  // Below the upper head, three columns of the band become one: where half the band has a multiple of three.
  bool coarseBelow = false;
};
SectionMesh railSectionMesh(const RailSectionSizes& sizes);

}  // namespace squat::geometry
