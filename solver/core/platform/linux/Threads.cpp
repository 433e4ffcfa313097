#include "core/platform/Threads.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

namespace squat::platform {

long timesCoreWasLost() {
#if defined(RUSAGE_THREAD)
  rusage usage{};
  if (::getrusage(RUSAGE_THREAD, &usage) == 0) return usage.ru_nivcsw;
#endif
  return 0;
}

std::chrono::nanoseconds processorTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void waitWhile(const std::atomic<unsigned>& value, unsigned old) { value.wait(old, std::memory_order_acquire); }
void wakeWaiting(std::atomic<unsigned>& value) { value.notify_all(); }

// Linux keeps the value for each thread.
void giveWay() {
  constexpr int politeness = 5;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), politeness);
}

}  // namespace squat::platform
