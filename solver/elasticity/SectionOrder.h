// solver/elasticity/SectionOrder.h - the order in which a kernel goes through the nodes of a section.
//
// Neighbours follow each other closely, so that only a short window of nodes is worked on at any time and its sums and
// differences stay in cache (breadth first, the best of all starts: Cuthill and McKee 1969). Nodes of a cluster wait
// for each other: when the force of its last one is found, they are ready to be advanced. They stand together in the
// list of places, in the order in which clusters become ready; so do their forces while they wait.
#pragma once

#include <vector>

#include "elasticity/SweptKernel.h"

namespace squat::elasticity {

struct SectionOrder {
  std::vector<int> nodes;        // node of each row
  std::vector<int> rowStart;     // rows + 1: pairs in the order of the rows
  std::vector<int> pairs;        // of each of them: index of the pair in the block's own order
  std::vector<int> slots;        // and the place of its column's node in the window
  std::vector<int> bundleStart;  // bundles + 1: first row of each bundle
  std::vector<int> gatherUpTo;   // per row: so many nodes of the order must stand in the window
  int window = 0;                // nodes
  std::vector<int> members;      // node of each place
  std::vector<int> memberSlot;   // where its forces wait
  std::vector<int> rowSlot;      // the same of each row
  std::vector<int> readyAfter;   // per row: so many places are ready when its force is found
  int forceSlots = 0;
  std::vector<KernelCluster> clusters;  // those of the caller, as they become ready
};

// For pairs of section nodes as in SweptBlock: row starts and columns; clusters of at most maximumRows nodes.
SectionOrder sectionOrder(const std::vector<int>& rowStart, const std::vector<int>& columns,
                          const std::vector<std::vector<int>>& clusters = {});

}  // namespace squat::elasticity
