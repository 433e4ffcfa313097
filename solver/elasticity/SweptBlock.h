// solver/elasticity/SweptBlock.h - a solid made by sweeping a section along a line or around the wheel's axis.
//
// All elements of one section quad within one run of stations are congruent and share one matrix. Displacements are
// kept in local components: a along the sweep, b and c in the section. Around the axis the basis turns with the
// station, so every sector of equal angle shares one matrix as well.
//
// Mirroring an interval at its middle swaps its stations and turns the sign of a. With sums s = u(right) + u(left) and
// differences d = u(right) - u(left), the interval's matrix therefore falls apart into two:
//   S: (d_a, s_b, s_c) -> (F_a, F_b, F_c)    T: (s_a, d_b, d_c) -> (F_a, F_b, F_c)
//   force on the right: b, c: S + T, a: T + S;   on the left: b, c: S - T, a: T - S.
// Both are assembled over the quads of the section: one 3x3 block of each for every pair of section nodes that share a
// quad, 18 numbers and 18 multiply-adds a pair instead of 288 an element.
//
// State vectors keep 32 stations of all lines together, [chunk][node][component][station in chunk]: a kernel works on
// one chunk at a time, whose memory is then one piece. Arrays with one line a node (mass, forces, accelerations) keep
// whole lines of `stride` stations.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/Hexahedron.h"
#include "elasticity/SectionOrder.h"
#include "elasticity/SelectiveMassScaling.h"
#include "elasticity/SweptKernel.h"
#include "geometry/SectionMesh.h"
#include "geometry/Stations.h"
#include "scenario/Material.h"

namespace squat::elasticity {

enum class SweepKind {
  alongX,     // (a, b, c) = (x, y, z); section coordinates (y, z)
  alongY,     // (a, b, c) = (y, z, x); section coordinates (z, x)
  aroundAxis  // (a, b, c) = (e_alpha, e_r, e_y); section coordinates (r, y); e_r = (sin alpha, 0, -cos alpha): alpha =
              // 0 is the lowest point, growing towards +x. Rolling in +x turns material points towards smaller alpha.
};

// One component of one section node along all stations of a state vector.
template <typename Number>
struct StateLine {
  Number* first = nullptr;
  std::size_t jump = 0;  // from a chunk to the next
  Number& operator[](int station) const { return first[(station >> 5) * jump + (station & 31)]; }
};

struct SweptBlock {
  static constexpr int chunk = stationChunk;
  std::string name;
  SweepKind kind = SweepKind::alongX;
  geometry::SectionMesh section;
  geometry::Stations stations;  // every run a multiple of 8 intervals
  scenario::Material material;
  double lean = 0;  // [rad] alongX: the section, and b and c with it, turned about x, its top towards -y
  // Section nodes that share the inertia of short waves, and the longest intervals (in the unit of the stations) that
  // do so along the sweep; no clusters: none (SelectiveMassScaling.h, SectionClusters.h).
  std::vector<std::vector<int>> clusters;
  double shortLength = 0;
  // Per station, what is left of the section's extent in b above its lowest node; empty: all of it. Positions and
  // masses have it; the operator sweeps the whole section, and irregular elements make up for it (IrregularElements.h).
  std::vector<double> extent;
  Eigen::Vector3d origin{0, 0, 0};  // [m] added to the swept position; around the axis: the axis at y = 0

  // Filled by prepareBlock().
  int nodes = 0, intervals = 0, stationCount = 0;
  bool closed = false;
  std::size_t stride = 0;              // stations of a whole line, multiple of 8, ghost station included
  std::size_t offset = 0;              // of the block in a state vector
  std::vector<double> positions;       // intervals + 1 station positions
  std::vector<double> cosines, sines;  // around the axis: of them
  AlignedVector stationMass;  // per station: its share of the section's mass along the sweep, in the stations' unit
  std::vector<int> rowStart, columns;                  // pairs of section nodes: nodes + 1, pairs
  std::vector<std::vector<double>> coefficients;       // per run: 18 per pair: S row-major, then T
  SectionOrder order;                                  // of the kernels
  std::vector<std::vector<double>> rowCoefficients;    // the same numbers in the order of the kernels
  std::vector<std::vector<float>> singleCoefficients;  // and rounded
  std::vector<std::array<int, 2>> runIntervals;        // per run: first interval and one past the last
  double lowest = 0;                                   // [m] b of the lowest section node
  int middle = 0, far = 0;                             // section nodes next to the centre of mass and farthest from it
  SelectiveMassScaling inertia;

  std::size_t lines() const { return static_cast<std::size_t>(nodes) * 3; }
  std::size_t chunkSize() const { return lines() * chunk; }
  std::size_t size() const { return (stride + chunk - 1) / chunk * chunkSize(); }
  std::size_t index(int node, int component, int station) const {
    const auto s = static_cast<std::size_t>(station);
    return offset + s / chunk * chunkSize() + (static_cast<std::size_t>(node) * 3 + component) * chunk + s % chunk;
  }
  struct Unknown {
    int node = 0, component = 0, station = 0;
  };
  Unknown unknownAt(std::size_t index) const {  // the inverse of index()
    const std::size_t at = index - offset, line = at % chunkSize() / chunk;
    return {static_cast<int>(line / 3), static_cast<int>(line % 3),
            static_cast<int>(at / chunkSize() * chunk + at % chunk)};
  }
  template <typename Number>
  StateLine<Number> line(Number* state, int node, int component) const {
    return {state + index(node, component, 0), chunkSize()};
  }
  std::size_t elements() const { return section.quads.size() * static_cast<std::size_t>(intervals); }
  int runOf(int interval) const;
};

// Numbers the nodes of a section anew, in the order in which the kernels will go through them.
void numberAsVisited(geometry::SectionMesh& section, std::vector<std::vector<int>>& clusters);

// Computes everything below the comment; throws std::invalid_argument for a run that is no multiple of 8.
void prepareBlock(SweptBlock& block);

// What `extent` moves a node by, local components [m].
Eigen::Vector3d extentShift(const SweptBlock& block, int node, int station);

// Position of a node in the reference configuration; around the axis in the configuration where the wheel has not
// turned.
Eigen::Vector3d nodePosition(const SweptBlock& block, int node, int station);

// Columns are the local basis vectors (a, b, c) of a station in global axes.
Eigen::Matrix3d localBasis(const SweptBlock& block, double stationPosition);

// Corners of an element in the axes of the middle of its interval, left station first, and its local-to-local
// rotations.
Corners elementCorners(const SweptBlock& block, int quad, double intervalLength);

// Stiffness of one element in local components, 24x24: left quad nodes, then right; 3 components each.
Matrix24 elementStiffness(const SweptBlock& block, int quad, double intervalLength);

// Turns the 24 local displacements of an element into axes of the interval's middle.
Matrix24 localToMiddle(const SweptBlock& block, double intervalLength);

// What an interval gives to the mass of its two stations together, up to the section's share: its length, around the
// axis, where elements are flat between their stations, the sine of its angle.
double massOfInterval(const SweptBlock& block, double length);

// The lumped mass of the block: one value per node and station, at node * stride + station.
// The ghost station of a closed block is left at zero.
std::vector<double> lumpedMass(const SweptBlock& block);  // nodes x stride

// Diagonal of the stiffness in state layout (size()).
std::vector<double> stiffnessDiagonal(const SweptBlock& block);

}  // namespace squat::elasticity
