// solver/geometry/RailSection.h - the true sections of the rails 54E1 and 60E1 and their mesh.
#pragma once

#include "geometry/SectionMesh.h"
#include "scenario/Track.h"

namespace squat::geometry {

using scenario::RailSection;

// Dimensions of a section [m]: head after EN 13674-1 (R300, R80, R13, side 1:20, underside 1:2.75); what is fitted to
// the published area, centroid and moments stands with the values in RailSection.cpp.
struct RailProfile {
  double crownRadius, crownEnd;                  // of the middle arc, and |y| to which it goes
  double shoulderRadius, shoulderEnd, touchEnd;  // of the next; a wheel touches within touchEnd, just inside its end
  double cornerRadius, sideStartY, sideStartZ;   // of the last, and where the side begins
  double height, headDepth, footDepth;           // depths: where the fishing surfaces meet the axis
  double webHalf, webRadius, webMiddle;          // thinnest at the height webMiddle
  double headFillet, footFillet;
  double footHalf, footBreak, footEdge;  // top of the foot: 1:2.75 to |y| = footBreak, straight to the edge's height
};
const RailProfile& railProfile(RailSection section);

// Right half of the outline (y >= 0), z = 0 on the running surface, up positive [m].
struct RailOutline {
  std::vector<Point2> crown;      // middle of the running surface to the middle of the R13 arc
  std::vector<Point2> headSide;   // from there to the lower corner of the head
  std::vector<Point2> underside;  // from the middle of the head-web fillet to the lower corner
  std::vector<Point2> web;        // from the middle of the head-web fillet to the middle of the web-foot fillet
  std::vector<Point2> footTop;    // from there to the upper edge of the foot
};
RailOutline railOutline(RailSection section);

// Height of the crown z(y) [m] and its slope, |y| within R300 and R80; R13 is not reached by a wheel that rolls
// centrally.
double crownHeight(RailSection section, double y);
double crownSlope(RailSection section, double y);

struct RailSectionSizes {
  double contactSize = 0;    // [m] quads in the contact band
  double bandHalfWidth = 0;  // [m]
  double sectionSize = 0;    // [m] largest quads
  double growth = 0;         // [-] of neighbouring quads away from the band
  // Below the upper head, three columns of the band become one: where half the band has a multiple of three.
  bool coarseBelow = false;
};
SectionMesh railSectionMesh(RailSection section, const RailSectionSizes& sizes);

}  // namespace squat::geometry
