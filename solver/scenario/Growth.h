// solver/scenario/Growth.h - what changes the rail over many passages: wear and the traffic that passes.
#pragma once

namespace squat::scenario {

enum class WearModel { none, archard, tGamma };

struct Growth {
  WearModel wear = WearModel::archard;
  double wearCoefficient = 0;  // [-] Archard's: worn volume times hardness over load times sliding distance
  double hardness = 0;         // [Pa] of the rail
  int wheelsets = 1;           // that stand for the traffic
  double traction = 0;         // torque over wheel load times radius, mean of the traffic
  // Standard deviations of what differs between them: contact along the crown [m], sprung mass and speed as shares of
  // their own, traction.
  double lateralScatter = 0, loadScatter = 0, speedScatter = 0, tractionScatter = 0;
  int seed = 1;
  double blockChange = 0;  // [m] of the surface's shape, at most, from one block to the next
};

}  // namespace squat::scenario
