// solver/growth/RailSurface.h - heights on the nodes of the running surface, between them and the contact points.
//
// The shape that wheels meet counts from the rail far from the defect: what wear and flow do everywhere lowers the rail
// and excites nothing. So the mean over a reference stretch ahead of the defect is taken off line by line, and the rest
// fades out at both ends of the zone.
#pragma once

#include <vector>

#include "contact/ContactSurfaces.h"
#include "model/Model.h"

namespace squat::growth {

using Field = std::vector<double>;  // a value for each node, ordered [station][line]

struct SurfaceGrid {
  std::vector<double> x, y;                   // [m] of stations along the rail and of lines along the crown
  std::vector<int> nodes;                     // section nodes of the lines
  int firstStation = 0;                       // of the rail
  double taper = 0;                           // [m] over which changes fade in and out at the ends
  double referenceFrom = 0, referenceTo = 0;  // [m] stretch of undisturbed rail

  std::size_t size() const { return x.size() * y.size(); }
  std::size_t index(std::size_t station, std::size_t line) const { return station * y.size() + line; }
};

// All stations of the rail between `from` and `to` [m], and the lines of its running surface.
SurfaceGrid surfaceGrid(const model::Model& model, double from, double to);

// Mean of what stands at the contact points about each node, weighted by their areas: the volume stays.
Field meanAtNodes(const SurfaceGrid& grid, const contact::Surfaces& surfaces, const std::vector<double>& atPoints);

// [m] vertical displacement of the nodes, up.
Field risenNodes(const SurfaceGrid& grid, const model::Model& model, const AlignedVector& displacement);

// Less the mean of the reference stretch, faded out at the ends.
Field relativeShape(const SurfaceGrid& grid, const Field& change);

// Mean over the reference stretch and the lines about `y` [m].
double referenceHeight(const SurfaceGrid& grid, const Field& change, double y);

// Along a line at y [m] of the crown.
std::vector<double> lineAt(const SurfaceGrid& grid, const Field& field, double y);

double steepestAlong(const SurfaceGrid& grid, const Field& shape);  // [-]

// Contact surfaces as built, and with a change laid on them.
struct BareSurface {
  std::vector<double> height, pointY;
  double reach = 0;
};
BareSurface bareSurface(const contact::Surfaces& surfaces);
// `change` [m]: what the points rise by besides what their nodes are displaced; `steepest` of the shape that is met.
void layChange(const SurfaceGrid& grid, const Field& change, double steepest, const BareSurface& bare,
               contact::Surfaces& surfaces);

}  // namespace squat::growth
