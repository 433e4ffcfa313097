#include "core/platform/Threads.h"

#include <pthread/qos.h>
#include <time.h>

namespace squat::platform {

long timesCoreWasLost() { return 0; }  // counted for the whole process only

std::chrono::nanoseconds processorTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void waitWhile(const std::atomic<unsigned>& value, unsigned old) { value.wait(old, std::memory_order_acquire); }
void wakeWaiting(std::atomic<unsigned>& value) { value.notify_all(); }

void giveWay() { ::pthread_set_qos_class_self_np(QOS_CLASS_UTILITY, 0); }

}  // namespace squat::platform
