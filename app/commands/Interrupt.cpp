#include "commands/Interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "commands/ExitCodes.h"

namespace squat::commands {

namespace {

// A signal handler can reach nothing but a global.
std::atomic<int> signalsSeen{0};
static_assert(std::atomic<int>::is_always_lock_free);

void onSignal(int) {
  if (signalsSeen.fetch_add(1) > 0) ::_exit(kCancelled);
}

void setHandlers(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) ::sigaction(number, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signalsSeen = 0;
  setHandlers(onSignal);
}
InterruptGuard::~InterruptGuard() { setHandlers(SIG_DFL); }
bool InterruptGuard::asked() { return signalsSeen.load() > 0; }

}  // namespace squat::commands
