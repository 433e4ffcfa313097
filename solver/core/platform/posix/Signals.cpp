#include "core/platform/Signals.h"

#include <signal.h>

#include <initializer_list>

namespace squat::platform {

namespace {

void setInterruptHandler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) ::sigaction(number, &action, nullptr);
}

sigset_t fileSizeSignal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGXFSZ);
  return set;
}

}  // namespace

void handleInterrupts(void (*handler)(int)) { setInterruptHandler(handler); }
void leaveInterruptsToTheSystem() { setInterruptHandler(SIG_DFL); }

void ignoreFileSizeSignal() { ::signal(SIGXFSZ, SIG_IGN); }
void endWhereAPipeIsClosed() { ::signal(SIGPIPE, SIG_DFL); }

FileSizeSignalBlocked::FileSizeSignalBlocked() {
  const auto set = fileSizeSignal();
  sigset_t before;
  sigemptyset(&before);
  ::pthread_sigmask(SIG_BLOCK, &set, &before);
  wasBlocked_ = sigismember(&before, SIGXFSZ) == 1;
}

// What came meanwhile is taken away before the signal may come again.
FileSizeSignalBlocked::~FileSizeSignalBlocked() {
  if (wasBlocked_) return;
  const auto set = fileSizeSignal();
  const timespec now{};
  while (::sigtimedwait(&set, nullptr, &now) > 0) {
  }
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace squat::platform
