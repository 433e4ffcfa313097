// solver/dynamics/StepShares.h - who does what of a step: stations, ties, fixed unknowns and force elements shared
// among the threads. A step gives the same bits for any shares (SweptWork.h, ForceShares.h).
#pragma once

#include <cstddef>
#include <vector>

#include "elasticity/SweptWork.h"
#include "forces/ForceShares.h"
#include "model/Model.h"

namespace squat::dynamics {

struct TieShare {
  std::size_t tie = 0;
  elasticity::StationSpan masters;
  std::vector<elasticity::StationSpan> slaves;
};

// Of one thread. Masters are the wheel body's stations, to which the rim is tied: they follow the others.
struct ThreadShare {
  std::vector<elasticity::Segment> stations, masters;
  std::vector<elasticity::SegmentEnds> stationEnds, masterEnds;
  std::vector<TieShare> placed;    // tied nodes that it places
  std::vector<TieShare> served;    // master stations that it advances
  std::vector<std::size_t> fixed;  // fixed unknowns of its stations
};

// A sleeper, which whoever is free advances as a whole.
struct SleeperShare {
  std::vector<elasticity::Segment> stations;
  std::vector<elasticity::SegmentEnds> ends;
  std::vector<std::size_t> fixed;  // its fixed unknowns
};

struct StepShares {
  std::vector<ThreadShare> threads;
  std::vector<SleeperShare> sleepers;
  bool wheelsetOfOne = false;           // the last thread has all of it: it waits for nobody between rim and body
  std::vector<unsigned char> endsLate;  // per block: its ends are read when tied nodes are placed
  forces::ForceShare vehicleForces;     // of the first thread, which knows the journal
  std::vector<forces::ForceShare> trackForces;  // taken by whoever is free
  std::size_t forceGroups = 0;
  double work = 0;  // of all threads, their other work included, in nodes along a line
};

// Work of each thread apart from its stations, in nodes along a line that cost the same. A first guess: the contact,
// for the first thread.
std::vector<double> firstGuessOfOtherWork(const model::Model& model, int threads);
// Shares for as many threads as `otherWork` has entries, of about equal cost.
StepShares shareStep(const model::Model& model, const std::vector<double>& otherWork);

}  // namespace squat::dynamics
