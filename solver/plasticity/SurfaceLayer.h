// solver/plasticity/SurfaceLayer.h - the elements of the rail head that may yield, laid out for vectors along the
// stations.
//
// Bilinear elastic-plastic steel: von Mises, associated flow, linear hardening, isotropic or kinematic (Prager). The
// swept operator stays elastic; plastic strain enters as initial stress: its element force is added to the outer forces
// of the layer's nodes. Such a force never stiffens: the tangent of a yielding element lies between its hardening and
// its elastic stiffness, so the stable step of the elastic model holds.
//
// A group is one section quad over 8 intervals. Its state has 8 points x 6 rows x 8 lanes (intervals): plastic strain
// xx, yy, 2xy, 2yz, 2zx (zz = -xx - yy, plastic flow keeps the volume) and equivalent plastic strain.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/IrregularElements.h"
#include "elasticity/SweptBlock.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::plasticity {

inline constexpr int lanes = 8;                           // intervals of a group
inline constexpr int points = 8, rows = 6;                // integration points; state rows of a point
inline constexpr int groupState = points * rows * lanes;  // doubles
inline constexpr int groupForce = 24 * lanes;

struct BilinearLaw {
  double shearModulus = 0, yieldStress = 0;  // [Pa]
  double isotropic = 0, kinematic = 0;       // plastic moduli H = E Et / (E - Et) [Pa]; one of them is zero
};
BilinearLaw bilinearLaw(const scenario::Rail& rail);

struct SurfaceLayer {
  BilinearLaw law;
  std::vector<int> quads;                      // section quads that may yield
  std::vector<int> indexOfQuad;                // per section quad: its place in quads, or -1
  std::vector<std::array<int, 4>> corners;     // their nodes
  int firstInterval = 0, groups = 0;           // groups along the rail; multiples of 8 intervals
  std::vector<std::array<double, 2>> extent;   // per group along: from, to [m]
  std::vector<AlignedVector> shapes;           // coefficients (LayerKernel.h) of one shape, or of 8 where `own`
  std::vector<int> shapeOf;                    // per group: into shapes
  std::vector<unsigned char> own;              // per group: its elements are not congruent, one shape a lane
  std::size_t blockOffset = 0, chunkSize = 0;  // of the block in the state (SweptBlock.h)
  std::size_t stride = 0;                      // of the block's force lines

  bool empty() const { return quads.empty() || groups == 0; }
  std::size_t size() const { return quads.size() * static_cast<std::size_t>(groups); }  // groups
  std::size_t elements() const { return size() * lanes; }
  std::size_t group(int along, std::size_t quad) const { return static_cast<std::size_t>(along) * quads.size() + quad; }
  // State index of a corner of a quad.
  std::size_t index(std::size_t quad, int corner, int component, int station) const {
    constexpr std::size_t chunk = elasticity::SweptBlock::chunk;
    const auto s = static_cast<std::size_t>(station), node = static_cast<std::size_t>(corners[quad][corner]);
    return blockOffset + s / chunk * chunkSize + (node * 3 + component) * chunk + s % chunk;
  }
  int station(int along) const { return firstInterval + lanes * along; }
};

// Everything that flows; a checkpoint holds just this. Empty where the layer is.
struct LayerState {
  AlignedVector values;  // groups x groupState
};

using elasticity::NodeShift;

// Quads whose centre lies within `depth` [m] of the polyline through the section nodes `surface`, over the intervals
// [first, first + count), widened to whole groups. Moved nodes: `moved` gives their shift (node, station), null for
// none.
SurfaceLayer makeLayer(const elasticity::SweptBlock& rail, const BilinearLaw& law, const std::vector<int>& surface,
                       double depth, int first, int count, const NodeShift& moved = {});

LayerState restState(const SurfaceLayer& layer);

// Section nodes of the layer, ascending.
std::vector<int> layerNodes(const SurfaceLayer& layer);

}  // namespace squat::plasticity
