// solver/detection/CancellableLoop.h - a loop on all threads that stops when it is cancelled.
#pragma once

#include <cstddef>
#include <functional>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"

namespace squat::detection {

// body(0) to body(count - 1), each once, in any order; false where it was cancelled: then some may be missing. The
// monitor is asked between two of them, by the calling thread. `onDone`, by that thread too: how many are done.
bool forEachUnlessCancelled(ThreadTeam& team, Monitor& monitor, std::size_t count,
                            const std::function<void(std::size_t)>& body,
                            const std::function<void(std::size_t)>& onDone = {});

}  // namespace squat::detection
