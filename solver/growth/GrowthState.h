// solver/growth/GrowthState.h - all that changes while a rail grows old; a checkpoint holds just this.
#pragma once

#include <string>
#include <vector>

#include "growth/RailSurface.h"
#include "plasticity/SurfaceLayer.h"
#include "results/ArrayTree.h"

namespace squat::growth {

// Of one passage, the mean over the traffic.
struct Rates {
  Field wear, flow;  // [m] rise of the surface: of wear negative
};

// The rail at the end of a block.
struct Stage {
  double tonnage = 0, passages = 0;  // [kg], wheelsets since the start
  double block = 0;                  // wheelsets of the block before it
  bool ground = false;               // just now
  // Along the line on which the case's wheel runs, from the rail far from the defect.
  double depth = 0, deepest = 0, length = 0;  // [m] of the dip, where it is deepest, and between 5 % of its depth
  double waveLength = 0, waveHeight = 0;      // [m] strongest wave behind the dip in what has changed; crest to valley
  double wear = 0, flow = 0;                  // [m] lost and sunk at the deepest place, positive
  double wearAround = 0, flowAround = 0;      // [m] on the rail far from the defect
  double largestStrain = 0, strainDepth = 0;  // accumulated, and [m] how deep
  double strainedDepth = 0;                   // [m] down to which strain exceeds what counts as strained
  double largestForce = 0, smallestForce = 0, peakAcceleration = 0;  // of the case's own wheelset; [N], [m/s2]
  bool operator==(const Stage&) const = default;
};

struct GrowthState {
  Field wear, flow, cut;               // [m] rise of the surface since the start; cut: by grinding, from the new level
  plasticity::LayerState layer;        // empty where nothing yields; hardened by all passages (LayerChange.h)
  plasticity::LayerState layerBefore;  // all wheelsets rolled over it the last time
  AlignedVector displacement;          // that its plastic strain leaves behind
  // [-] share of what the shape of a node has changed by that flow takes back in one passage, as seen in the last
  // block.
  Field relaxation;
  Rates rates;  // at this moment
  double tonnage = 0, passages = 0, block = 0;
  std::vector<Stage> stages;
  std::vector<Field> shapes;  // of each stage: heights of the nodes, defect included
  std::size_t grindings = 0;  // done
};

results::ArrayTree treeOf(const GrowthState& state);
// Throws FileError where the tree lacks something.
GrowthState stateFrom(const results::ArrayTree& tree, const std::string& file);

}  // namespace squat::growth
