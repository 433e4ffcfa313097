#include "elasticity/SweptWork.h"

#include <algorithm>
#include <cmath>

namespace squat::elasticity {

namespace {

// A node that turns with its body costs more than one along a line: its basis turns with the station and the step, its
// moment is summed. The last station of an open block goes alone and costs as much as several (seen on sleepers).
constexpr double turningCost = 1.1, lastStationCost = 8;
// Who begins a ring computes eight stations of the interval before it, one vector at a time, and reads its ends first
// (measured). That others begin within a block as well is not counted.
constexpr double beginCost = 12;

double costOf(const SweptBlock& block, int first, int count) {
  const double turning = block.kind == SweepKind::aroundAxis ? turningCost : 1.0;
  const bool endsOpen = !block.closed && first + count == block.intervals;
  const bool ringBegins = block.closed && first == 0;
  return block.nodes * turning * (count + (endsOpen ? lastStationCost : 0) + (ringBegins ? beginCost : 0));
}

KernelCall callFor(const SweptBlock& block, int index, int first, int count, const double* source,
                   KernelScratch& scratch) {
  KernelCall call;
  call.nodes = block.nodes;
  call.order = block.order.nodes.data();
  call.bundleStart = block.order.bundleStart.data();
  call.bundles = static_cast<int>(block.order.bundleStart.size()) - 1;
  call.rowStart = block.order.rowStart.data();
  call.slots = block.order.slots.data();
  call.gatherUpTo = block.order.gatherUpTo.data();
  call.window = block.order.window;
  call.members = block.order.members.data(), call.memberSlot = block.order.memberSlot.data();
  call.rowSlot = block.order.rowSlot.data(), call.readyAfter = block.order.readyAfter.data();
  call.middle = block.middle, call.far = block.far;
  call.coordinates = block.section.nodes.front().data();
  call.runs = scratch.runs[index].data();
  call.stride = block.stride;
  call.stationMass = block.stationMass.data();
  call.chunkSize = block.chunkSize();
  call.first = first, call.count = count;
  call.source = source + block.offset;
  if (!block.cosines.empty()) call.cosines = block.cosines.data(), call.sines = block.sines.data();
  call.carry = scratch.carry.data();
  call.workspace = scratch.workspace.data(), call.waiting = scratch.waiting.data();
  return call;
}

// Ends that nobody else reads or writes: those of an open block.
bool beginsAlone(const SweptBlock& block, const Segment& segment) { return !block.closed && segment.first == 0; }
bool endsAlone(const SweptBlock& block, const Segment& segment) {
  return !block.closed && segment.first + segment.count == block.intervals;
}

// What the interval before `first` adds to that station; nothing at the open end of a block.
void startCarry(const SweptBlock& block, int index, const KernelSet& kernels, int first, const double* source,
                KernelScratch& scratch) {
  std::fill(scratch.carry.begin(), scratch.carry.end(), 0.0);
  if (first == 0 && !block.closed) return;
  kernels.carryOver(callFor(block, index, first == 0 ? block.intervals : first, 0, source, scratch));
}

void refreshGhost(const SweptBlock& block, double* state) {
  for (int n = 0; n < block.nodes; ++n)
    for (int c = 0; c < 3; ++c) state[block.index(n, c, block.intervals)] = state[block.index(n, c, 0)];
}

// The last station of an open block has only its left interval: the carry.
void advanceLastStation(const SweptBlock& block, const BlockStep& with, double step, const double* source,
                        double* target, double* velocity, KernelScratch& scratch) {
  const int s = block.intervals;
  const double* carry = scratch.carry.data();
  const auto outerForce = [&](int n) {
    const int triple = with.lineOfNode[n];
    return triple < 0 ? nullptr : with.force + static_cast<std::size_t>(triple) * 3 * block.stride + s;
  };
  double* accelerations = scratch.lastAccelerations.data();
  for (int n = 0; n < block.nodes; ++n) {
    const double inverse =
        with.inverseMass[(s / SweptBlock::chunk * block.nodes + n) * SweptBlock::chunk + s % SweptBlock::chunk];
    double* outer = outerForce(n);
    for (int c = 0; c < 3; ++c) {
      if (with.slave[n]) {
        outer[c * block.stride] = carry[3 * n + c];
        continue;
      }
      double total = -carry[3 * n + c];
      if (outer) total += outer[c * block.stride], outer[c * block.stride] = 0;
      accelerations[3 * n + c] = total * inverse;
    }
  }
  scaleMassAcross(block, accelerations);
  for (int n = 0; n < block.nodes; ++n) {
    if (with.slave[n]) continue;
    for (int c = 0; c < 3; ++c) {
      const double acceleration =
          accelerations[3 * n + c] +
          (with.acceleration ? with.acceleration[c * block.stride + s] : with.evenAcceleration[c]);
      const std::size_t here = block.index(n, c, s);
      const double old = velocity[here];
      velocity[here] = (old + step * acceleration) * (with.acceleration ? with.freeMask[3 * n + c] : 1.0);
      target[here] = source[here] - with.beta * old + (step + with.beta) * velocity[here];
    }
  }
}

}  // namespace

std::vector<std::vector<Segment>> partition(const std::vector<SweptBlock>& blocks, const std::vector<int>& which,
                                            int parts, int costly, double factor) {
  return partition(blocks, which, std::vector<double>(static_cast<std::size_t>(parts), 0.0), costly, factor);
}

double costOf(const std::vector<SweptBlock>& blocks, const std::vector<int>& which, int costly, double factor) {
  double total = 0;
  for (const int b : which) total += costOf(blocks[b], 0, blocks[b].intervals) * (b == costly ? factor : 1.0);
  return total;
}

std::vector<std::vector<Segment>> partition(const std::vector<SweptBlock>& blocks, const std::vector<int>& which,
                                            const std::vector<double>& otherWork, int costly, double factor) {
  const auto cost = [&](int b, int first, int count) {
    return costOf(blocks[b], first, count) * (b == costly ? factor : 1.0);
  };
  double total = costOf(blocks, which, costly, factor);
  for (const double extra : otherWork) total += extra;
  const double each = total / static_cast<double>(otherWork.size());
  std::vector<std::vector<Segment>> lists(otherWork.size());
  std::size_t part = 0;
  double done = otherWork.front();  // by this part
  for (const int b : which)
    for (int at = 0, count = 0; at < blocks[b].intervals; at += count) {
      count = std::min(maximumStations, blocks[b].intervals - at);  // those that share their inertia stay together
      const double here = cost(b, at, count);
      // To the part in whose share the middle of these intervals lies.
      while (part + 1 < otherWork.size() && done + 0.5 * here >= each) done += otherWork[++part] - each;
      auto& list = lists[part];
      if (!list.empty() && list.back().block == b)
        list.back().count += count;
      else
        list.push_back({b, at, count});
      done += here;
    }
  return lists;
}

KernelScratch::KernelScratch(const std::vector<SweptBlock>& blocks) {
  int maximum = 0, window = 0, slots = 0;
  for (const auto& block : blocks) {
    maximum = std::max(maximum, block.nodes), window = std::max(window, block.order.window);
    slots = std::max(slots, block.order.forceSlots);
  }
  for (const auto& block : blocks) {
    auto& own = runs.emplace_back();
    for (std::size_t r = 0; r < block.runIntervals.size(); ++r) {
      const auto& along = block.inertia.along[r];
      own.push_back({block.runIntervals[r][0], block.runIntervals[r][1], block.stations.runs[r].length,
                     block.rowCoefficients[r].data(), block.singleCoefficients[r].data(),
                     along.empty() ? nullptr : along.data(),
                     along.empty() ? nullptr : block.inertia.singleAlong[r].data()});
    }
  }
  workspace.assign(kernelWorkspace(window), 0.0);
  waiting.assign(forceWorkspace(slots), 0.0);
  carry.assign(static_cast<std::size_t>(maximum) * 3 + 8, 0.0);
  lastAccelerations.assign(static_cast<std::size_t>(maximum) * 3, 0.0);
}

void applySegments(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks,
                   const KernelSet& kernels, const double* source, double* result, KernelScratch& scratch) {
  for (const auto& segment : segments) {
    const auto& block = blocks[segment.block];
    startCarry(block, segment.block, kernels, segment.first, source, scratch);
    auto call = callFor(block, segment.block, segment.first, segment.count, source, scratch);
    call.force = result + block.offset;
    kernels.applyStiffness(call);
    if (endsAlone(block, segment))
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 3; ++c) result[block.index(n, c, block.intervals)] = scratch.carry[3 * n + c];
  }
}

std::vector<SegmentEnds> segmentEnds(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks) {
  std::vector<SegmentEnds> ends(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const int nodes = blocks[segments[i].block].nodes;
    ends[i].carry.resize(3 * nodes), ends[i].after.resize(3 * nodes);
  }
  return ends;
}

void readEnd(const Segment& segment, const std::vector<SweptBlock>& blocks, const std::vector<BlockStep>& steps,
             const double* source, KernelScratch& scratch, SegmentEnds& end) {
  const auto& block = blocks[segment.block];
  if (!beginsAlone(block, segment)) {
    startCarry(block, segment.block, *steps[segment.block].kernels, segment.first, source, scratch);
    std::copy_n(scratch.carry.begin(), 3 * block.nodes, end.carry.begin());
  }
  if (endsAlone(block, segment)) return;
  for (int n = 0; n < block.nodes; ++n)
    for (int c = 0; c < 3; ++c) end.after[3 * n + c] = source[block.index(n, c, segment.first + segment.count)];
}

void advanceSegments(const std::vector<Segment>& segments, const std::vector<SweptBlock>& blocks,
                     const std::vector<BlockStep>& steps, double step, const double* source, double* target,
                     double* velocity, KernelScratch& scratch, const std::vector<SegmentEnds>* ends) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& segment = segments[i];
    const auto& block = blocks[segment.block];
    const auto& with = steps[segment.block];
    if (ends)
      std::copy((*ends)[i].carry.begin(), (*ends)[i].carry.end(), scratch.carry.begin());
    else
      startCarry(block, segment.block, *with.kernels, segment.first, source, scratch);
    auto call = callFor(block, segment.block, segment.first, segment.count, source, scratch);
    call.inverseMass = with.inverseMass, call.evenInverse = with.evenInverse, call.fixedMask = with.freeMask;
    call.externalLine = with.lineOfNode, call.slave = with.slave, call.external = with.force;
    call.velocity = velocity + block.offset, call.target = target + block.offset;
    call.acceleration = with.acceleration, call.radialWeight = with.radialWeight;
    std::copy_n(with.evenAcceleration, 3, call.evenAcceleration);
    call.angularAcceleration = with.angularAcceleration, call.step = step, call.beta = with.beta;
    call.cosine = with.cosine, call.sine = with.sine;
    call.turningMoment = with.turningMoment;
    call.clusters = block.inertia.clusters.data(), call.clusterCount = static_cast<int>(block.inertia.clusters.size());
    call.clusterWeights = block.inertia.weights.data();
    call.singleClusterWeights = block.inertia.singleWeights.data();
    call.shortShare = block.inertia.share;
    call.ownFilter = with.ownFilter, call.filters = with.filters;
    call.stationUnits = block.intervals / stationUnit;
    if (ends && !endsAlone(block, segment)) call.after = (*ends)[i].after.data();
    with.kernels->advanceStep(call);
    if (endsAlone(block, segment)) advanceLastStation(block, with, step, source, target, velocity, scratch);
    if (block.closed && segment.first == 0) refreshGhost(block, target);
  }
}

AlignedVector inChunks(const SweptBlock& block, const double* lines) {
  AlignedVector values(block.size() / 3, 0.0);
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s < static_cast<int>(block.stride); ++s)
      values[(s / SweptBlock::chunk * block.nodes + n) * SweptBlock::chunk + s % SweptBlock::chunk] =
          lines[n * block.stride + s];
  return values;
}

// Products are the same but for rounding.
std::vector<double> evenInverseMass(const SweptBlock& block, const double* inverseLines, const int* lineOfNode) {
  std::vector<double> even(block.nodes, 0.0);
  for (int n = 0; n < block.nodes; ++n) {
    if (lineOfNode[n] >= 0) continue;
    const double* inverse = inverseLines + n * block.stride;
    const double first = inverse[0] * block.stationMass[0];
    bool isEven = true;
    for (int s = 0; s < block.stationCount; ++s)
      isEven = isEven && std::abs(inverse[s] * block.stationMass[s] - first) <= 1e-12 * first;
    if (isEven) even[n] = first;
  }
  return even;
}

void refreshGhosts(const std::vector<SweptBlock>& blocks, double* state) {
  for (const auto& block : blocks)
    if (block.closed) refreshGhost(block, state);
}

}  // namespace squat::elasticity
