// tests/simulation/StoppedRuns.h - runs that are stopped half-way, and what two runs must have in common to the bit.
#pragma once

#include "core/Monitor.h"
#include "results/ResultTree.h"

namespace squat::tests {

// Cancels when the given share of the rolling is done.
class CancelAt : public Monitor {
 public:
  explicit CancelAt(double share) : share_(share) {}
  void report(const Progress& progress) override {
    if (progress.phase == "rolling" && progress.fraction >= share_) cancelled_ = true;
  }
  bool cancelled() override { return cancelled_; }

 private:
  double share_;
  bool cancelled_ = false;
};

// Everything but what tells of the machine and the clock.
inline results::ArrayTree comparable(results::RunResult result) {
  result.performance.clear();
  result.threads = 0;
  result.created.clear();
  return results::toTree(result);
}

}  // namespace squat::tests
