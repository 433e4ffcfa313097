#include "core/platform/Threads.h"

#include <time.h>

namespace squat::platform {

std::chrono::nanoseconds processorTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void waitWhile(const std::atomic<unsigned>& value, unsigned old) { value.wait(old, std::memory_order_acquire); }
void wakeWaiting(std::atomic<unsigned>& value) { value.notify_all(); }

}  // namespace squat::platform
