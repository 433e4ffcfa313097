// solver/geometry/SectionMesh.h - a plane mesh of quadrilaterals that is swept along a line or around an axis.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace squat::geometry {

using Point2 = std::array<double, 2>;

// Section coordinates (b, c) [m]: rail (y, z), sleeper (z, x), wheel (radius, y). Quads turn counter-clockwise, so that
// sweep direction, b and c form a right-handed triad.
struct SectionMesh {
  std::vector<Point2> nodes;
  std::vector<std::array<int, 4>> quads;
};

// Scaled Jacobian of a quad: smallest over its corners of sin(corner angle), negative when inverted. 1 is a rectangle.
double scaledJacobian(const SectionMesh& mesh, int quad);

// Ratio of the longest to the shortest edge.
double aspectRatio(const SectionMesh& mesh, int quad);

// Nodes for which the predicate holds, ordered by the coordinate `axis` (0 or 1).
std::vector<int> nodesWhere(const SectionMesh& mesh, const std::function<bool(const Point2&)>& predicate, int axis);

// Area, centroid and second moments about the centroid of a section, by Gauss integration over the quads.
struct SectionIntegrals {
  double area = 0;                      // [m2]
  double centroidB = 0, centroidC = 0;  // [m]
  double momentBB = 0;                  // integral of (b - centroidB)^2 [m4]
  double momentCC = 0;                  // integral of (c - centroidC)^2 [m4]
};
SectionIntegrals sectionIntegrals(const SectionMesh& mesh);

// A structured block of quads between four edges (transfinite interpolation). bottom and top run in the first
// direction, left and right in the second; corners must coincide. The first direction crossed with the second must
// point along the sweep. The lowest `coarseRows` rows have one quad where the others have three side by side, with a
// row between that joins them; the columns are a multiple of three then.
class BlockMesher {
 public:
  explicit BlockMesher(double mergeTolerance) : tolerance_(mergeTolerance) {}
  void addBlock(const std::vector<Point2>& bottom, const std::vector<Point2>& top, const std::vector<Point2>& left,
                const std::vector<Point2>& right, int coarseRows = 0);
  // Quads between two lines of as many points, in rows of even height from the inner line to the outer one: the first
  // direction runs from line to line, the second along them.
  void addStrip(const std::vector<Point2>& inner, const std::vector<Point2>& outer, int rows);
  // Adds all quads so far mirrored at b = 0.
  void mirror();
  SectionMesh take() { return std::move(mesh_); }

 private:
  int node(const Point2& point);
  void addJoiningRow(const std::vector<int>& below, const std::vector<int>& above);
  double tolerance_;
  SectionMesh mesh_;
};

// n+1 values from 0 to 1, the first spacing being `first` of the whole, then growing by a constant factor.
std::vector<double> gradedSpacing(int count, double first);

// Smallest number of intervals for a length, starting at `first` and growing by at most `growth` up to `largest`.
int intervalsFor(double length, double first, double growth, double largest);

}  // namespace squat::geometry
