// solver/supports/SpringShares.h - springs shared among threads.
//
// Springs that push at a common place, a group, stay together and in their order: forces are added up in the same order
// for any number of threads, and no two threads write one place.
#pragma once

#include <functional>
#include <vector>

#include "supports/Springs.h"

namespace squat::supports {

struct SpringShare {
  SpringSet springs;
  std::vector<std::size_t> group;   // per spring
  std::vector<std::size_t> groups;  // in this share
};

struct SharedSprings {
  std::vector<SpringShare> shares;
  std::size_t groups = 0;  // in all
};

// A group goes to the share that `ownerOf` names for the unknown of its first term; it must be in [0, shares).
SharedSprings shareSprings(const std::vector<const SpringSet*>& sets, int shares,
                           const std::function<int(std::size_t unknown)>& ownerOf);

// Adds the springs' forces [N] to the force buffer; `displacement` is u + beta v [m], `velocity` v [m/s]. What the
// dashpots of each group dissipate [W] goes to its place in `dissipation`.
void addSpringForces(const SpringShare& share, const double* displacement, const double* velocity, double* forces,
                     double* dissipation);

}  // namespace squat::supports
