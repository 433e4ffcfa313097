#include "detection/CancellableLoop.h"

#include <atomic>
#include <thread>

namespace squat::detection {

bool forEachUnlessCancelled(ThreadTeam& team, Monitor& monitor, std::size_t count,
                            const std::function<void(std::size_t)>& body,
                            const std::function<void(std::size_t)>& onDone) {
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done{0};
  std::atomic<bool> isCancelled{false};
  team.forEach(count, [&](std::size_t i) {
    if (isCancelled) return;
    body(i);
    ++done;
    if (std::this_thread::get_id() != caller) return;  // monitors belong to the thread that computes
    if (onDone) onDone(done);
    if (monitor.cancelled()) isCancelled = true;
  });
  return !isCancelled;
}

}  // namespace squat::detection
