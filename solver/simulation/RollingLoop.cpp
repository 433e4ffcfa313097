#include "simulation/RollingLoop.h"

#include <algorithm>
#include <thread>

namespace squat::simulation {

namespace {

using Clock = std::chrono::steady_clock;

long nextStop(const Observers& observers, long done, long lastStep) {
  long next = lastStep;
  for (const auto* observer : observers) next = std::min(next, observer->nextStep(done));
  return std::max(next, done + 1);
}

void restWhilePaused(Monitor& monitor, RunClock& clock) {
  const auto asked = Clock::now();
  while (monitor.paused() && !monitor.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  clock.leaveOut(Clock::now() - asked);
}

}  // namespace

double RunClock::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

LoopEnd roll(dynamics::Rolling& rolling, long lastStep, const Observers& observers, Monitor& monitor, RunClock& clock) {
  if (rolling.state().step == 0)
    for (auto* observer : observers) observer->onStart(rolling);
  while (rolling.state().step < lastStep) {
    const long done = rolling.state().step;
    rolling.advance(nextStop(observers, done, lastStep) - done, [&](const dynamics::StepView&) {
      for (auto* observer : observers) observer->onEveryStep(rolling);
    });
    for (auto* observer : observers) observer->onStep(rolling);
    restWhilePaused(monitor, clock);
    if (monitor.cancelled()) return LoopEnd::cancelled;
  }
  return LoopEnd::done;
}

}  // namespace squat::simulation
