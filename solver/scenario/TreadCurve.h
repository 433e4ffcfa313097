// solver/scenario/TreadCurve.h - radial deviation along one line around the tread, a closed curve.
#pragma once

#include <vector>

#include "scenario/MonotoneCubic.h"

namespace squat::scenario {

class TreadCurve {
 public:
  struct Node {
    double angle, deviation, slope;  // [rad], [m], [m/rad]
  };

  TreadCurve() = default;  // round
  // Monotone cubic through nodes whose angles ascend and span less than a turn; slopes are found here. The last node is
  // followed by the first.
  explicit TreadCurve(std::vector<Node> nodes);

  // Deviation [m] and its slope [m/rad] at any angle [rad].
  HeightAndSlope at(double angle) const;
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::vector<Node> nodes_;
};

}  // namespace squat::scenario
