#include "dynamics/StepShares.h"

#include <algorithm>
#include <utility>

namespace squat::dynamics {

namespace {

using elasticity::Segment;

// Stations that a segment advances: the last one of an open block as well.
elasticity::StationSpan stationsOf(const elasticity::SweptBlock& block, const Segment& segment) {
  const int last = segment.first + segment.count;
  return {segment.first, last + (!block.closed && last == block.intervals ? 1 : 0)};
}

// The first thread, which is busy with the contact, has rail alone. Where the last can have the whole wheelset, it
// advances the wheel body when it is done with the rim, and nobody waits. Sleepers even out what no share foresees.
void shareBlocks(const model::Model& model, const std::vector<double>& otherWork, StepShares& shares) {
  constexpr double tieCost =
      2.2;  // of a node of the wheel body, ties and slaves included, to one along a line (measured)
  const auto& blocks = model.blocks;
  std::vector<int> all{model.rail, model.rim, model.body};
  for (int b = model.firstSleeper; b < static_cast<int>(blocks.size()); ++b) {
    auto& sleeper = shares.sleepers.emplace_back();
    sleeper.stations = {{b, 0, blocks[b].intervals}};
    sleeper.ends = elasticity::segmentEnds(sleeper.stations, blocks);
  }
  const std::size_t threads = otherWork.size();
  auto together = elasticity::partition(blocks, all, otherWork, model.body, tieCost);
  shares.work = elasticity::costOf(blocks, all, model.body, tieCost);
  for (const double extra : otherWork) shares.work += extra;
  shares.wheelsetOfOne = true;
  for (std::size_t thread = 0; thread + 1 < threads; ++thread)
    for (const auto& segment : together[thread])
      shares.wheelsetOfOne = shares.wheelsetOfOne && segment.block != model.rim && segment.block != model.body;
  if (shares.wheelsetOfOne) {
    shares.threads.back().masters.push_back(together.back().back());
    together.back().pop_back();
    for (std::size_t i = 0; i < threads; ++i) shares.threads[i].stations = std::move(together[i]);
    return;
  }
  all.pop_back();
  auto fine = elasticity::partition(blocks, all, otherWork);
  // Most of the rim is tied to the first sectors of the wheel body and goes to the last threads: what they pass each
  // other stays in their own caches.
  auto masters = elasticity::partition(blocks, {model.body}, std::vector<double>(threads, 0.0));
  for (std::size_t i = 0; i < threads; ++i) {
    shares.threads[i].stations = std::move(fine[i]);
    shares.threads[i].masters = std::move(masters[threads - 1 - i]);
  }
}

// Who advances a tied node's stations places it, but for the first thread, which is busy with the contact: the last one
// does it there. Who advances a master's stations serves them.
void shareTies(const model::Model& model, StepShares& shares) {
  auto& threads = shares.threads;
  for (std::size_t index = 0; index < threads.size(); ++index) {
    auto& placed = threads[index == 0 ? threads.size() - 1 : index].placed;
    for (std::size_t t = 0; t < model.ties.size(); ++t) {
      const auto& tie = model.ties[t];
      for (const auto& segment : threads[index].masters) {
        if (segment.block != tie.masterBlock) continue;
        const auto own = stationsOf(model.blocks[segment.block], segment);
        threads[index].served.push_back({t, own, slaveSpans(tie, own.first, own.last)});
      }
      for (const auto& segment : threads[index].stations)
        if (segment.block == tie.slaveBlock)
          placed.push_back({t, {}, {stationsOf(model.blocks[segment.block], segment)}});
    }
  }
}

std::size_t blockOf(const model::Model& model, std::size_t unknown) {
  std::size_t b = 0;
  while (b + 1 < model.blocks.size() && model.blocks[b + 1].offset <= unknown) ++b;
  return b;
}

// Where a fixed unknown is listed: with who advances it.
std::vector<std::size_t>& listOf(const model::Model& model, StepShares& shares, std::size_t unknown) {
  if (unknown >= model.firstAuxiliary) return shares.threads.front().fixed;  // which fills and advances them
  const auto b = static_cast<int>(blockOf(model, unknown));
  if (b >= model.firstSleeper) return shares.sleepers[static_cast<std::size_t>(b - model.firstSleeper)].fixed;
  const int station = model.blocks[b].unknownAt(unknown).station;
  for (auto& own : shares.threads)
    for (const auto* work : {&own.stations, &own.masters})
      for (const auto& segment : *work) {
        const auto span = stationsOf(model.blocks[segment.block], segment);
        if (segment.block == b && station >= span.first && station < span.last) return own.fixed;
      }
  return shares.threads.front().fixed;
}

// Pieces of some microseconds, along the track.
void shareForces(const model::Model& model, StepShares& shares) {
  const int pieces = shares.threads.size() == 1 ? 1 : 8;
  const auto pieceOf = [&](std::size_t unknown) {
    if (unknown >= model.firstAuxiliary) return 0;
    const auto b = static_cast<int>(blockOf(model, unknown));
    const auto& block = model.blocks[b];
    const int sleepers = static_cast<int>(model.blocks.size()) - model.firstSleeper;
    if (b >= model.firstSleeper) return 1 + (b - model.firstSleeper) * pieces / sleepers;
    return 1 + block.unknownAt(unknown).station * pieces / block.stationCount;
  };
  auto forces = forces::shareForces(model.forceElements, 1 + pieces, pieceOf);
  shares.vehicleForces = std::move(forces.shares.front());
  for (std::size_t i = 1; i < forces.shares.size(); ++i)
    if (forces.shares[i].elements.size() > 0) shares.trackForces.push_back(std::move(forces.shares[i]));
  shares.forceGroups = forces.groups;
}

}  // namespace

// Some nodes, and 64 for each of the four points of a face within the patch (half axes 7 and 5.2 mm).
std::vector<double> firstGuessOfOtherWork(const model::Model& model, int threads) {
  constexpr double patchArea = 1.1e-4;  // [m2]
  const double contactSize = model.scenario.mesh.contactSize;
  std::vector<double> otherWork(static_cast<std::size_t>(threads), 0.0);
  if (threads > 1) otherWork.front() = 2500 + 64 * 4 * patchArea / (contactSize * contactSize);
  return otherWork;
}

StepShares shareStep(const model::Model& model, const std::vector<double>& otherWork) {
  StepShares shares;
  shares.threads.resize(otherWork.size());
  shareBlocks(model, otherWork, shares);
  for (auto& own : shares.threads) {
    own.stationEnds = elasticity::segmentEnds(own.stations, model.blocks);
    own.masterEnds = elasticity::segmentEnds(own.masters, model.blocks);
  }
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const bool isAlone = shares.wheelsetOfOne && static_cast<int>(b) == model.body;
    shares.endsLate.push_back(
        isAlone || std::any_of(model.slave[b].begin(), model.slave[b].end(), [](auto tied) { return tied != 0; }));
  }
  shareTies(model, shares);
  for (const auto unknown : model.fixed) listOf(model, shares, unknown).push_back(unknown);
  shareForces(model, shares);
  return shares;
}

}  // namespace squat::dynamics
