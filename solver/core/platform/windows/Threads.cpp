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

// std::atomic::wait() of GCC 12 looks at the value before it takes its lock, where there is no futex: a wake-up between
// the two was lost, and one run in six stood still for ever (measured).
void waitWhile(const std::atomic<unsigned>& value, unsigned old) {
  ::WaitOnAddress(const_cast<std::atomic<unsigned>*>(&value), &old, sizeof old, INFINITE);
}

void wakeWaiting(std::atomic<unsigned>& value) { ::WakeByAddressAll(&value); }

// Of the calling thread alone: those that it starts begin at the usual priority.
void giveWay() { ::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); }

}  // namespace squat::platform
