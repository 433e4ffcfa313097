// solver/dynamics/TeamPace.h - how threads that step together keep pace with each other and with the machine.
//
// The time that each thread works in a step is measured, waiting left out. Where one thread works longer than the
// others, the shares are cut again. Where other programs hold the cores, so that threads wait for one that has no core
// at present, one thread alone may be quicker than all: it then works alone for a while, before all are tried again.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

namespace squat::dynamics {

// Work of one thread in the steps of a window.
class WorkClock {
 public:
  // Forces are gathered by whoever is free; stations are advanced by shares.
  enum class Part { gathering, advancing };

  void resume() { last_ = Clock::now(); }
  void rest(Part part) { (part == Part::gathering ? gathering_ : advancing_) += Clock::now() - last_; }
  void endStep() {
    add(std::chrono::duration<double>(gathering_).count(), std::chrono::duration<double>(advancing_).count());
    gathering_ = advancing_ = {};
  }
  // A step whose parts took so long [s].
  void add(double gathering, double advancing) {
    if (steps_.size() == steps_.capacity()) return;  // enough for a window
    steps_.push_back(gathering + advancing);
    advances_.push_back(advancing);
  }

 private:
  friend class TeamPace;
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_;
  Clock::duration gathering_{}, advancing_{};
  std::vector<double> steps_, advances_;  // [s] whole, and the latter part
};

class TeamPace {
 public:
  // `otherWork`: what shareStep() begins with, one entry for each thread.
  explicit TeamPace(std::vector<double> otherWork);

  bool alone() const { return alone_; }  // one thread is to take the next steps
  const std::vector<double>& otherWork() const { return otherWork_; }
  WorkClock& clock(int thread) { return clocks_[static_cast<std::size_t>(thread)].clock; }

  // After `steps` steps in `seconds` of wall time, shared as by shareStep() with work `work`: true where shares are to
  // be cut again, with otherWork().
  bool advanced(long steps, double seconds, double work);

 private:
  void beginWindow();
  bool recut(const std::vector<double>& advancing, double work);
  struct alignas(128) OfThread {  // no two threads write to one cache line
    WorkClock clock;
  };
  std::vector<double> otherWork_;
  std::vector<OfThread> clocks_;
  bool alone_ = false;
  double aloneFor_;  // [s] next time
  long windowSteps_ = 0;
  double windowSeconds_ = 0;
  long done_ = 0, nextCut_ = 0;  // steps
};

}  // namespace squat::dynamics
