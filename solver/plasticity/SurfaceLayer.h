// solver/plasticity/SurfaceLayer.h - the elements of the rail head that may yield, laid out for vectors along the
// stations.
//
// Elastic-plastic steel: von Mises, associated flow, and one of three laws of hardening: linear isotropic, linear
// kinematic (Prager), or three back-stresses that recover, with isotropic hardening that saturates (J. L. Chaboche,
// Int. J. Plasticity 5, 1989): the last ratchets. A back-stress X of equivalent size |X| = sqrt(3/2 X:X) follows
//   dX = 2/3 modulus d eps_p - recovery f X dp,  f = 1 (P. J. Armstrong, C. O. Frederick, CEGB RD/B/N731, 1966), or
//   f = (|X| recovery / modulus)^exponent <X : d eps_p> / (|X| dp) (N. Ohno, J.-D. Wang, Int. J. Plasticity 9, 1993),
// which ratchets less. The
// swept operator stays elastic; plastic strain enters as initial stress: its element force is added to the outer forces
// of the layer's nodes. Such a force never stiffens: the tangent of a yielding element lies between its hardening and
// its elastic stiffness, so the stable step of the elastic model holds.
//
// A group is one section quad over 8 intervals. Its state has 8 points x rows x 8 lanes (intervals): plastic strain xx,
// yy, 2xy, 2yz, 2zx (zz = -xx - yy, plastic flow keeps the volume) and equivalent plastic strain; where back-stresses
// recover also all of them in the rows of strain, over 2 mu, the growth of the yield radius over 2 mu, and the plastic
// work per volume over 2 mu.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/IrregularElements.h"
#include "elasticity/SweptBlock.h"
#include "scenario/ScenarioDeclaration.h"
#include "scenario/Track.h"

namespace squat::plasticity {

inline constexpr int lanes = 8;   // intervals of a group
inline constexpr int points = 8;  // integration points of an element
inline constexpr int groupForce = 24 * lanes;

// State rows of a point.
namespace row {
inline constexpr int flow = 0, equivalent = 5, linear = 6;  // number of rows of the linear laws
inline constexpr int backstress = 6, growth = 21, work = 22, recovering = 23;
}  // namespace row

struct HardeningLaw {
  double shearModulus = 0, yieldStress = 0;  // [Pa]
  double isotropic = 0, kinematic = 0;       // plastic moduli H = E Et / (E - Et) [Pa] of the linear laws
  bool recovers = false;                     // else a linear law
  std::array<scenario::Backstress, 3> backstresses{};
  double exponent = 0;              // 0: Armstrong and Frederick
  double saturation = 0, rate = 0;  // [Pa], [-] of the yield stress: d growth = rate (saturation - growth) dp
};
HardeningLaw hardeningLaw(const scenario::Rail& rail);

struct SurfaceLayer {
  HardeningLaw law;
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
  int rows() const { return law.recovers ? row::recovering : row::linear; }                     // of a point's state
  std::size_t groupState() const { return static_cast<std::size_t>(points) * rows() * lanes; }  // doubles
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
SurfaceLayer makeLayer(const elasticity::SweptBlock& rail, const HardeningLaw& law, const std::vector<int>& surface,
                       double depth, int first, int count, const NodeShift& moved = {});

LayerState restState(const SurfaceLayer& layer);

// Section nodes of the layer, ascending.
std::vector<int> layerNodes(const SurfaceLayer& layer);

}  // namespace squat::plasticity
