// solver/forces/ForceShares.h - force elements shared among threads.
//
// Elements that push at a common place, a group, stay together and in their order: forces are added up in the same
// order for any number of threads, and no two threads write one place.
#pragma once

#include <functional>
#include <vector>

#include "forces/ForceElements.h"

namespace squat::forces {

struct ForceShare {
  // Elements of one set: a plain loop each.
  struct Run {
    std::size_t first = 0, last = 0;  // elements [first, last)
    std::optional<ElasticLaw> law;
  };
  ForceElements elements;           // of all sets, in their order
  std::vector<Run> runs;            // cover all elements
  std::vector<std::size_t> group;   // per element
  std::vector<std::size_t> groups;  // in this share
};

struct SharedForces {
  std::vector<ForceShare> shares;
  std::size_t groups = 0;  // in all
};

// A group goes to the share that `ownerOf` names for the unknown of its first term; it must be in [0, shares).
SharedForces shareForces(const std::vector<ForceElements>& sets, int shares,
                         const std::function<int(std::size_t unknown)>& ownerOf);

// Adds the elements' forces [N] to the force buffer; `displacement` is u + beta v [m], `velocity` v [m/s]. What the
// dashpots of each group dissipate [W] goes to its place in `dissipation`.
void addForces(const ForceShare& share, const double* displacement, const double* velocity, double* forces,
               double* dissipation);

}  // namespace squat::forces
