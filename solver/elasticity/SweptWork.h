// solver/elasticity/SweptWork.h - the swept operator over many blocks, cut into stretches of stations for threads.
//
// A station's force is the sum of what its left and its right interval add. A stretch that does not begin at the end of
// its block computes the interval before it once more, so that stretches are independent of each other and results do
// not depend on where the cuts are.
#pragma once

#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/SweptBlock.h"
#include "elasticity/SweptKernel.h"

namespace squat::elasticity {

struct Segment {
  int block = 0, first = 0, count = 0;  // intervals, multiples of 8
};

// Cuts the intervals of the named blocks into lists of about equal cost. The nodes of block `costly` cost `factor`
// times as much as others.
std::vector<std::vector<Segment>> partition(const std::vector<SweptBlock>& blocks, const std::vector<int>& which,
                                            int parts, int costly = -1, double factor = 1);
// The same, a list for each entry of `otherWork`: work of that cost (a node along a line: 1) that its thread has as
// well.
std::vector<std::vector<Segment>> partition(const std::vector<SweptBlock>& blocks, const std::vector<int>& which,
                                            const std::vector<double>& otherWork, int costly = -1, double factor = 1);
// Cost of the named blocks, in nodes along a line.
double costOf(const std::vector<SweptBlock>& blocks, const std::vector<int>& which, int costly = -1, double factor = 1);

// Scratch memory of one thread.
struct KernelScratch {
  explicit KernelScratch(const std::vector<SweptBlock>& blocks);
  AlignedVector workspace, waiting, carry, lastAccelerations;
  std::vector<std::vector<KernelRun>> runs;  // per block
};

// result := K source on the stations of the segments (state layout). The source's ghost stations must be up to date.
void applySegments(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks,
                   const KernelSet& kernels, const double* source, double* result, KernelScratch& scratch);

// What one block needs for a step besides source, target and velocity (state layout).
struct BlockStep {
  const KernelSet* kernels = nullptr;
  const double* inverseMass = nullptr;  // as from inChunks()
  const double* evenInverse = nullptr;  // as from evenInverseMass(); null: inverseMass alone
  const double* freeMask = nullptr;     // nodes x 3; not looked at without `acceleration`
  const int* lineOfNode = nullptr;      // into the force lines
  const unsigned char* slave = nullptr;
  double* force = nullptr;         // triples of lines, cleared when read
  const int* ownFilter = nullptr;  // KernelCall, as is the next
  const KernelFilter* filters = nullptr;
  const double* acceleration = nullptr;  // 3 lines; null: KernelCall
  double evenAcceleration[3] = {};
  const double* radialWeight = nullptr;
  double angularAcceleration = 0, beta = 0, cosine = 1, sine = 0;
  double* turningMoment = nullptr;  // closed blocks: KernelCall
};

// What a step in place needs of a segment's surroundings as they were before anybody wrote: room for it by
// segmentEnds(), filled by readEnd() for every segment before anybody advances in place.
struct SegmentEnds {
  AlignedVector carry;        // what the interval before the segment adds, nodes x 3; zero at an open end
  std::vector<double> after;  // KernelCall; not used at an open end, whose last station nobody else advances
};

std::vector<SegmentEnds> segmentEnds(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks);
void readEnd(const Segment& segment, const std::vector<SweptBlock>& blocks, const std::vector<BlockStep>& steps,
             const double* source, KernelScratch& scratch, SegmentEnds& end);

// One step of the central difference. `target` may be `source` where `ends` are given: a step then moves a fifth less
// memory.
void advanceSegments(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks,
                     const std::vector<BlockStep>& steps, double step, const double* source, double* target,
                     double* velocity, KernelScratch& scratch, const std::vector<SegmentEnds>* ends = nullptr);

// One value for each node and station, from lines of `stride` to the chunks of the state layout.
AlignedVector inChunks(const SweptBlock& block, const double* lines);

// Per node: inverse mass times station mass where that is one number at all stations and no outer force may act (no
// line), else 0. `inverseLines` in lines of `stride`. Masses that change during the run must be those of nodes with
// lines.
std::vector<double> evenInverseMass(const SweptBlock& block, const double* inverseLines, const int* lineOfNode);

// Copies station 0 of closed blocks to their ghost station.
void refreshGhosts(const std::vector<SweptBlock>& blocks, double* state);

}  // namespace squat::elasticity
