#include "core/platform/Threads.h"

#include <windows.h>

#include <cstdint>

namespace squat::platform {

long timesCoreWasLost() { return 0; }

std::chrono::nanoseconds processorTime() {
  FILETIME start{}, end{}, kernel{}, user{};
  if (!::GetThreadTimes(::GetCurrentThread(), &start, &end, &kernel, &user)) return {};
  const auto unitsOf = [](const FILETIME& time) {
    return static_cast<std::int64_t>(std::uint64_t{time.dwHighDateTime} << 32U | time.dwLowDateTime);
  };
  return std::chrono::nanoseconds(100 * (unitsOf(kernel) + unitsOf(user)));
}

// Of the calling thread alone: those that it starts begin at the usual priority.
void giveWay() { ::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); }

}  // namespace squat::platform
