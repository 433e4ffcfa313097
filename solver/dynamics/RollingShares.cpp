// Who does what of a step: stations, ties, fixed degrees of freedom and force elements shared among the threads.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dynamics/Rolling.h"

namespace squat::dynamics {

namespace {

// Stations that a segment advances: the last one of an open block as well.
elasticity::StationSpan stationsOf(const elasticity::SweptBlock& block, const elasticity::Segment& segment) {
  const int last = segment.first + segment.count;
  return {segment.first, last + (!block.closed && last == block.intervals ? 1 : 0)};
}

}  // namespace

// The first thread, which is busy with the contact, has rail alone. Where the last can have the whole wheelset, it
// advances the wheel body when it is done with the rim, and nobody waits.
void Rolling::shareBlocks() {
  constexpr double tieCost =
      2.2;  // of a node of the wheel body, ties and slaves included, to one along a line (measured)
  // What the first thread's stations under the contact cost besides, in nodes along a line: some, and 64 for each of
  // the four points of a face within the patch (half axes 7 and 5.2 mm). Fitted with two threads, where the last waited
  // for it; left out for more.
  constexpr double patchArea = 1.1e-4;  // [m2]
  const double contactSize = model_.scenario.mesh.contactSize;
  const double contactCost = team_.size() == 2 ? 2500 + 64 * 4 * patchArea / (contactSize * contactSize) : 0;
  const auto& blocks = model_.blocks;
  std::vector<int> all{model_.rail};
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b)
    if (b != model_.rim && b != model_.body && b != model_.rail) all.push_back(b);
  all.push_back(model_.rim), all.push_back(model_.body);
  const int threads = team_.size();
  auto together = elasticity::partition(blocks, all, threads, model_.body, tieCost, contactCost);
  wheelsetOfOne_ = true;
  for (int thread = 0; thread + 1 < threads; ++thread)
    for (const auto& segment : together[thread])
      wheelsetOfOne_ = wheelsetOfOne_ && segment.block != model_.rim && segment.block != model_.body;
  if (wheelsetOfOne_) {
    masterWork_.resize(static_cast<std::size_t>(threads));
    masterWork_.back().push_back(together.back().back());
    together.back().pop_back();
    fineWork_ = std::move(together);
    requireWholeSleepers();
    return;
  }
  all.pop_back();
  fineWork_ = elasticity::partition(blocks, all, threads);
  requireWholeSleepers();
  masterWork_ = elasticity::partition(blocks, {model_.body}, threads);
  // Most of the rim is tied to the first sectors of the wheel body and goes to the last threads: what they pass each
  // other stays in their own caches.
  std::reverse(masterWork_.begin(), masterWork_.end());
}

// One thread adds all forces of a sleeper's height before it advances it in place.
void Rolling::requireWholeSleepers() const {
  if (model_.sleeperShape.size() == 0) return;
  for (const auto& work : fineWork_)
    for (const auto& segment : work)
      if (segment.block >= model_.firstSleeper && segment.count < model_.blocks[segment.block].intervals)
        throw std::invalid_argument("a sleeper of unequal height has too many stations to stay with one thread");
}

// Who advances a tied node's stations places it, but for the first thread, which is busy with the contact: the last one
// does it there. Who advances a master's stations serves them.
void Rolling::shareTies() {
  slaveShares_.resize(static_cast<std::size_t>(team_.size()));
  std::size_t maximum = 0;
  for (const auto& tie : model_.ties) maximum = std::max(maximum, elasticity::tieWorkspace(tie));
  for (int index = 0; index < team_.size(); ++index) {
    tieWorkspaces_.emplace_back(maximum, 0.0);
    auto& placed = slaveShares_[static_cast<std::size_t>(index == 0 ? team_.size() - 1 : index)];
    tieShares_.emplace_back();
    for (std::size_t t = 0; t < model_.ties.size(); ++t) {
      const auto& tie = model_.ties[t];
      for (const auto& segment : masterWork_[index]) {
        if (segment.block != tie.masterBlock) continue;
        const elasticity::StationSpan own = stationsOf(model_.blocks[segment.block], segment);
        tieShares_.back().push_back({t, own, slaveSpans(tie, own.first, own.last)});
      }
      for (const auto& segment : fineWork_[index])
        if (segment.block == tie.slaveBlock)
          placed.push_back({t, {}, {stationsOf(model_.blocks[segment.block], segment)}});
    }
  }
}

int Rolling::ownerOf(std::size_t unknown) const {
  if (unknown >= model_.firstAuxiliary) return 0;  // which fills and advances them
  std::size_t b = 0;
  while (b + 1 < model_.blocks.size() && model_.blocks[b + 1].offset <= unknown) ++b;
  const int station = model_.blocks[b].unknownAt(unknown).station;
  for (int thread = 0; thread < team_.size(); ++thread)
    for (const auto* work : {&fineWork_[thread], &masterWork_[thread]})
      for (const auto& segment : *work) {
        const auto own = stationsOf(model_.blocks[segment.block], segment);
        if (segment.block == static_cast<int>(b) && station >= own.first && station < own.last) return thread;
      }
  return 0;
}

void Rolling::shareFixed() {
  fixedOf_.resize(static_cast<std::size_t>(team_.size()));
  for (const auto unknown : model_.fixed) fixedOf_[static_cast<std::size_t>(ownerOf(unknown))].push_back(unknown);
}

void Rolling::shareForceElements() {
  auto shared =
      forces::shareForces(model_.forceElements, team_.size(), [this](std::size_t unknown) { return ownerOf(unknown); });
  forceShares_ = std::move(shared.shares);
  groupDamperPowers_.assign(shared.groups, 0.0);
}

}  // namespace squat::dynamics
