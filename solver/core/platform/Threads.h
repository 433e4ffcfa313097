// solver/core/platform/Threads.h - the calling thread and the core that it runs on.
#pragma once

#include <atomic>
#include <chrono>

namespace squat::platform {

// Times that the calling thread has lost its core to others against its will; 0: not known.
long timesCoreWasLost();

// That the calling thread has had.
std::chrono::nanoseconds processorTime();

// In a loop that waits for another thread: the processor spends less on it meanwhile. In the header, since a call would
// take as long as the pause.
inline void pauseOfAWait() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb");  // `yield` does nothing on most of these processors; this takes about as long as x86's pause
#endif
}

// Sleeps while `value` is `old`, until wakeWaiting(); may return before.
void waitWhile(const std::atomic<unsigned>& value, unsigned old);
void wakeWaiting(std::atomic<unsigned>& value);

// The calling thread, and those that it starts from here on, let the others of the machine go first.
void giveWay();

}  // namespace squat::platform
