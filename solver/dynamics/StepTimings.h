// solver/dynamics/StepTimings.h - where the threads of a run spend the time of a step.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace squat::dynamics {

// What a thread does in a step, in this order; see Rolling.h.
enum class StepPhase {
  wheelset,       // kinematics, contact and torque
  forceElements,  // of pads, ballast and suspension
  tiedNodes,      // displacements from their masters
  layer,          // plastic flow of the surface layer
  ends,           // what the thread reads beyond its own stations
  stations,       // inner forces and advance
  masters,        // of tied nodes: their forces, inner forces and advance
  sleepers,       // inner forces and advance
  motion,         // angular velocity and sums at the end of the step
  observers,      // signals, checks and energy balance
  waiting         // for other threads
};
inline constexpr std::size_t stepPhases = 11;

const char* nameOf(StepPhase phase);

// Seconds of each phase and thread, summed over steps. A clock is read some ten times per thread and step, 0.3 us
// together.
class StepTimings {
 public:
  // The first phase of every thread begins now.
  explicit StepTimings(int threads) : threads_(static_cast<std::size_t>(threads)) {
    for (auto& own : threads_) own.last = Clock::now();
  }

  // The time since the last call of this thread was spent in `phase`.
  void end(int thread, StepPhase phase) {
    auto& own = threads_[static_cast<std::size_t>(thread)];
    const auto now = Clock::now();
    own.sums[static_cast<std::size_t>(phase)] += now - own.last;
    own.last = now;
  }
  void countSteps(long steps) { steps_ += steps; }

  int threads() const { return static_cast<int>(threads_.size()); }
  long steps() const { return steps_; }
  double seconds(int thread, StepPhase phase) const {
    return std::chrono::duration<double>(
               threads_[static_cast<std::size_t>(thread)].sums[static_cast<std::size_t>(phase)])
        .count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct alignas(128) OfThread {  // no two threads write to one cache line
    std::array<Clock::duration, stepPhases> sums{};
    Clock::time_point last{};
  };
  std::vector<OfThread> threads_;
  long steps_ = 0;
};

}  // namespace squat::dynamics
