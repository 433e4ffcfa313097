// solver/elasticity/SectionClusters.h - which section nodes share the inertia of short waves (SelectiveMassScaling.h).
#pragma once

#include <functional>
#include <vector>

#include "elasticity/SweptBlock.h"

namespace squat::elasticity {

// Clusters of neighbouring section nodes, of several ways to form them the one that lowers the highest frequency of
// the section in plane strain most. What is left is a cluster of its own each, but nodes for which `mayJoin` is false
// (tied nodes) are in none. The block is prepared.
// A fixed search: the same section gives the same clusters.
std::vector<std::vector<int>> sectionClusters(const SweptBlock& block, const std::function<bool(int)>& mayJoin);

}  // namespace squat::elasticity
