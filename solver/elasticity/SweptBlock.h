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
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "elasticity/Hexahedron.h"
#include "geometry/SectionMesh.h"
#include "geometry/Stations.h"

namespace squat::elasticity {

enum class SweepKind {
  alongX,     // (a, b, c) = (x, y, z); section coordinates (y, z)
  alongY,     // (a, b, c) = (y, z, x); section coordinates (z, x)
  aroundAxis  // (a, b, c) = (e_alpha, e_r, e_y); section coordinates (r, y); e_r = (sin alpha, 0, -cos alpha): alpha =
              // 0 is the lowest point, growing towards +x. Rolling in +x turns material points towards smaller alpha.
};

struct SweptBlock {
  std::string name;
  SweepKind kind = SweepKind::alongX;
  geometry::SectionMesh section;
  geometry::Stations stations;  // every run a multiple of 8 intervals
  cases::Material material;
  Eigen::Vector3d origin{0, 0, 0};  // [m] added to the swept position; around the axis: the axis at y = 0

  // Filled by prepareBlock().
  int nodes = 0, intervals = 0, stationCount = 0;
  bool closed = false;
  std::size_t stride = 0;              // doubles between two component lines, multiple of 8, ghost station included
  std::size_t offset = 0;              // of the block's first line in a state vector
  std::vector<double> positions;       // intervals + 1 station positions
  std::vector<int> rowStart, columns;  // pairs of section nodes: nodes + 1, pairs
  std::vector<std::vector<double>> coefficients;  // per run: 18 per pair: S row-major, then T
  std::vector<std::array<int, 2>> runIntervals;   // per run: first interval and one past the last

  std::size_t lines() const { return static_cast<std::size_t>(nodes) * 3; }
  std::size_t size() const { return lines() * stride; }
  std::size_t index(int node, int component, int station) const {
    return offset + (static_cast<std::size_t>(node) * 3 + component) * stride + station;
  }
  std::size_t elements() const { return section.quads.size() * static_cast<std::size_t>(intervals); }
  int runOf(int interval) const;
};

// Computes everything below the comment; throws std::invalid_argument for a run that is no multiple of 8.
void prepareBlock(SweptBlock& block);

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

// Adds the lumped mass of the block to mass[offset/3-like layout]: one value per node and station, index nodeIndex().
// The ghost station of a closed block is left at zero.
std::vector<double> lumpedMass(const SweptBlock& block);  // nodes x stride

// Diagonal of the stiffness in state layout (size()).
std::vector<double> stiffnessDiagonal(const SweptBlock& block);

}  // namespace squat::elasticity
