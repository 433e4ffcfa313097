// The steps of Rolling: which thread does what, and when they meet.
#include <chrono>
#include <numeric>
#include <utility>

#include "dynamics/Rolling.h"
#include "model/BuildForceElements.h"

namespace squat::dynamics {

void Rolling::advance(long steps, const std::function<void(const StepView&)>& observe) {
  const auto begun = std::chrono::steady_clock::now();
  const long first = state_.step;
  const bool alone = pace_.alone();
  for (auto* side : sides_) side->nextForces_.at = 0, side->taken_ = alone ? &side->oneShare_ : &side->shares_;
  if (alone)
    takeSteps(0, first, steps, observe);
  else
    team_.runInStep([&](int index) { takeSteps(index, first, steps, observe); });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun;
  if (pace_.advanced(steps, seconds.count(), shares_.work))
    for (auto* side : sides_) side->shares_ = shareStep(side->model_, pace_.otherWork());
  if (timings_) timings_->end(0, StepPhase::waiting), timings_->countSteps(steps);
  finishSides();
  if (timings_) timings_->end(0, StepPhase::motion);
  observe(view_);
  if (timings_) timings_->end(0, StepPhase::observers);
}

// Of one thread. The first one closes a step and begins the next while others already collect forces.
void Rolling::takeSteps(int index, long first, long steps, const std::function<void(const StepView&)>& observe) {
  const auto threads = static_cast<int>(taken_->threads.size());
  const bool together = threads > 1, wheelsetOfOne = taken_->wheelsetOfOne;
  auto& clock = pace_.clock(index);
  const auto done = [&](StepPhase phase) {
    if (timings_) timings_->end(index, phase);
  };
  auto part = WorkClock::Part::gathering;
  const auto meet = [&] {
    if (!together) return;
    clock.rest(part);
    team_.barrier();
    clock.resume();
    done(StepPhase::waiting);
  };
  const auto each = [&](StepPhase phase, const auto& work) {
    for (auto* side : sides_) work(*side, side->taken_->threads[static_cast<std::size_t>(index)]);
    done(phase);
  };
  done(index == 0 ? StepPhase::observers : StepPhase::waiting);
  clock.resume();
  for (long k = 0; k < steps; ++k) {
    if (index == 0) {
      if (k > 0) {
        finishSides();
        done(StepPhase::motion);
        observe(view_);
        done(StepPhase::observers);
      }
      nextSleeper_.at = 0;
      pushSides();
      each(StepPhase::wheelset, [&](Rolling& side, ThreadShare&) {
        side.addContactInertia(0);
        if (!wheelsetOfOne) side.addContactInertia(1);
      });
    }
    each(StepPhase::forceElements, [&](Rolling& side, ThreadShare&) { side.pushForceElements(index); });
    each(StepPhase::tiedNodes, [&](Rolling& side, ThreadShare& own) {
      if (!wheelsetOfOne) side.placeTiedNodes(own, index);
    });
    each(StepPhase::layer, [&](Rolling& side, ThreadShare&) { side.yieldLayer(index, threads, first + k); });
    each(StepPhase::ends, [&](Rolling& side, ThreadShare& own) { side.readEnds(own, index, false); });
    meet();
    part = WorkClock::Part::advancing;
    if (index == 0)
      for (auto* side : sides_) side->sumDamperPower(), side->nextForces_.at = 0;
    each(StepPhase::tiedNodes, [&](Rolling& side, ThreadShare& own) {
      if (wheelsetOfOne && index + 1 == threads) side.addContactInertia(1);
      if (wheelsetOfOne) side.placeTiedNodes(own, index);
    });
    each(StepPhase::ends, [&](Rolling& side, ThreadShare& own) { side.readEnds(own, index, true); });
    if (!wheelsetOfOne) meet();
    each(StepPhase::stations, [&](Rolling& side, ThreadShare& own) { side.advanceStations(own, index); });
    if (!wheelsetOfOne) meet();
    each(StepPhase::masters, [&](Rolling& side, ThreadShare& own) {
      side.passTieForces(own, index);
      side.advanceMasters(own, index);
      side.fix(own.fixed);
    });
    joinAxle(taken_->threads[static_cast<std::size_t>(index)]);
    done(StepPhase::masters);
    advanceSleepers(index);
    done(StepPhase::sleepers);
    meet();
    part = WorkClock::Part::gathering;
    clock.endStep();
  }
}

// The elements of the vehicle push the journal: their forces are passed on to the seat there.
void Rolling::pushForceElements(int index) {
  const auto& shares = *taken_;
  const auto add = [&](const forces::ForceShare& share) {
    forces::addForces(share, state_.displaced.data(), state_.velocity.data(), forces_.data(),
                      groupDamperPowers_.data());
  };
  if (index == 0) {
    add(shares.vehicleForces);
    double* auxiliary = forces_.data() + model_.forceSize - model::auxiliaryUnknowns;
    const model::PlaneVector force{std::exchange(auxiliary[model_.journalX - model_.firstAuxiliary], 0.0),
                                   std::exchange(auxiliary[model_.journalZ - model_.firstAuxiliary], 0.0)};
    addRingForce(model_, model_.bearing, turned_, force, forces_.data());
  }
  for (std::size_t i = nextForces_.at++; i < shares.trackForces.size(); i = nextForces_.at++)
    add(shares.trackForces[i]);
}

void Rolling::sumDamperPower() {
  damperPower_ = std::accumulate(groupDamperPowers_.begin(), groupDamperPowers_.end(), 0.0);
}

void Rolling::placeTiedNodes(const ThreadShare& own, int index) {
  for (const auto& share : own.placed)
    interpolateSlaves(model_.ties[share.tie], model_.blocks, state_.displaced.data(), tieWorkspaces_[index].data(),
                      share.slaves.front());
}

// Plastic flow in the layer around the patch, shared among the threads by groups.
void Rolling::yieldLayer(int index, int threads, long step) {
  if (model_.layer.empty()) return;
  const double x = model_.startX + model_.scenario.motion.speed * static_cast<double>(step) * step_;
  plasticity::returnWindow(model_.layer, layerKernels_, state_.displaced.data(), x, model_.surfaces.reach, index,
                           threads, state_.plastic, layerForces_);
}

// A step in place overwrites what neighbouring stretches need: each thread reads that first. Blocks with slaves come
// when those are placed, the others before.
void Rolling::readEnds(ThreadShare& own, int index, bool late) {
  const auto& shares = *taken_;
  const auto read = [&](const std::vector<elasticity::Segment>& work, std::vector<elasticity::SegmentEnds>& ends) {
    for (std::size_t i = 0; i < work.size(); ++i)
      if (shares.endsLate[work[i].block] == late)
        elasticity::readEnd(work[i], model_.blocks, blockSteps_, state_.displaced.data(), *scratch_[index], ends[i]);
  };
  read(own.stations, own.stationEnds);
  read(own.masters, own.masterEnds);
}

void Rolling::advanceStations(const ThreadShare& own, int index) {
  // Each thread adds the forces of plastic strain to the stations that it will advance.
  if (!model_.layer.empty())
    for (const auto& part : own.stations)
      if (part.block == model_.rail)
        plasticity::addPlasticForces(model_.layer, layerForces_, part.first, part.first + part.count,
                                     forces_.data() + model_.loaded[part.block].offset,
                                     model_.loaded[part.block].lineOfNode.data());
  elasticity::advanceSegments(own.stations, model_.blocks, blockSteps_, step_, state_.displaced.data(),
                              state_.displaced.data(), state_.velocity.data(), *scratch_[index], &own.stationEnds);
}

void Rolling::advanceSleepers(int index) {
  const std::size_t sleepers = taken_->sleepers.size();
  for (std::size_t i = nextSleeper_.at++; i < sleepers; i = nextSleeper_.at++) {
    for (auto* side : sides_) side->advanceSleeper(side->taken_->sleepers[i], index);
    joinSleepers(taken_->sleepers[i]);
  }
}

void Rolling::advanceSleeper(SleeperShare& sleeper, int index) {
  const int block = sleeper.stations.front().block;
  if (model_.sleeperShape.size() > 0)
    elasticity::addIrregularForces(model_.sleeperShape, state_.displaced.data() + model_.blocks[block].offset,
                                   forces_.data() + model_.loaded[block].offset);
  elasticity::advanceSegments(sleeper.stations, model_.blocks, blockSteps_, step_, state_.displaced.data(),
                              state_.displaced.data(), state_.velocity.data(), *scratch_[index], &sleeper.ends);
  fix(sleeper.fixed);
}

void Rolling::passTieForces(const ThreadShare& own, int index) {
  for (const auto& share : own.served) {
    const auto& tie = model_.ties[share.tie];
    const auto &slave = model_.blocks[tie.slaveBlock], &master = model_.blocks[tie.masterBlock];
    const auto &from = model_.loaded[tie.slaveBlock], &to = model_.loaded[tie.masterBlock];
    // Inner forces of slaves pull their masters the other way round than outer ones: negative share.
    elasticity::transferForces(
        tie, -1.0,
        [&](int i, int c) {
          return forces_.data() + from.offset +
                 (static_cast<std::size_t>(from.lineOfNode[tie.slaveNodes[i]]) * 3 + c) * slave.stride;
        },
        [&](int node, int c) {
          return forces_.data() + to.offset + (static_cast<std::size_t>(to.lineOfNode[node]) * 3 + c) * master.stride;
        },
        tieWorkspaces_[index].data(), share.masters.first, share.masters.last, share.slaves);
  }
}

void Rolling::advanceMasters(const ThreadShare& own, int index) {
  elasticity::advanceSegments(own.masters, model_.blocks, blockSteps_, step_, state_.displaced.data(),
                              state_.displaced.data(), state_.velocity.data(), *scratch_[index], &own.masterEnds);
}

}  // namespace squat::dynamics
