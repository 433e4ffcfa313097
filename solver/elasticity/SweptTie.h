// solver/elasticity/SweptTie.h - joins a fine swept block (slave) to a coarser one (master) along a surface.
//
// A slave node takes the displacement of the master hexahedron at its true place (trilinear, extrapolated where a chord
// leaves the arc), so translations and small rotations pass exactly. Both blocks are swept alike, so the weights are a
// product: section weights of the slave node times station weights of its station. Around the axis the radial
// coordinate within the master depends on the station (chord against arc), hence the extrapolation factor e: outer (1 +
// e) - inner e.
#pragma once

#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/SweptBlock.h"

namespace squat::elasticity {

constexpr int tieStations = 64;

// Two numbers that are worked on together.
typedef double Two __attribute__((vector_size(16)));

// Stations [first, last).
struct StationSpan {
  int first = 0, last = 0;
};

struct SweptTie {
  int slaveBlock = 0, masterBlock = 0;
  std::vector<int> slaveNodes;

  // Columns: pairs of master section nodes (outer, inner) that slaves refer to.
  struct Column {
    int outer = 0, inner = 0;
  };
  std::vector<Column> columns;
  // Section weights: slave node i uses entries [entryStart[i], entryStart[i + 1]).
  std::vector<int> entryStart, entryColumn;
  std::vector<double> entryWeight;

  // Per slave station: master stations left and right of it, and their weights.
  struct Stations {
    std::vector<int> left, right;
    std::vector<double> leftWeight, rightWeight, extrapolation;
    // The same as they are multiplied: for components a and b cosine and sine of the turn from the master's to the
    // slave's basis times the weight, for c the left and the right weight; and all times the extrapolation.
    struct Turned {
      Two left, right, leftBeyond, rightBeyond;
      Two across, acrossBeyond;
    };
    std::vector<Turned> turned;
  };
  Stations stations;
  // Slave stations between the same two master stations follow each other: stretches of at most tieStations, by their
  // ends, and the stretch of every station.
  std::vector<int> stretchEnd, stretchOf;
};

// Slave nodes are given by the caller and must lie on edges of master quads (section coordinates); for around-axis
// blocks the master's section is made of rectangles in (r, y). Throws std::invalid_argument when a slave lies outside.
SweptTie makeTie(const std::vector<SweptBlock>& blocks, int slaveBlock, int masterBlock, std::vector<int> slaveNodes);

// Workspace of a tie [doubles]: columns x 3 components x the stations that are worked on at a time. As many as fit the
// first-level cache: with eight, memory came in pieces too short to be fetched ahead.
std::size_t tieWorkspace(const SweptTie& tie);

// slave := interpolation of master, in a state vector (whole layout); at all stations, or at those of one span.
void interpolateSlaves(const SweptTie& tie, const std::vector<SweptBlock>& blocks, double* state, double* workspace);
void interpolateSlaves(const SweptTie& tie, const std::vector<SweptBlock>& blocks, double* state, double* workspace,
                       StationSpan span);

// Stretches of slave stations that reach master stations [first, last).
std::vector<StationSpan> slaveSpans(const SweptTie& tie, int firstMaster, int lastMaster);

// The transpose: forces of the slaves, times `sign`, are added to master stations [firstMaster, lastMaster), whose
// spans are given; a span holds whole stretches. `slaveLine(i, c)` gives the line of component c of slave node i,
// `masterLine(node, c)` that of a master's section node. Threads may take ranges of master stations; sums are in the
// same order for any ranges.
template <typename SlaveLine, typename MasterLine>
void transferForces(const SweptTie& tie, double sign, const SlaveLine& slaveLine, const MasterLine& masterLine,
                    double* workspace, int firstMaster, int lastMaster, const std::vector<StationSpan>& spans);

}  // namespace squat::elasticity

#include "elasticity/SweptTieTransfer.h"
