#include "commands/Interrupt.h"

#include <atomic>

#include "commands/ExitCodes.h"
#include "core/platform/Process.h"
#include "core/platform/Signals.h"

namespace squat::commands {

namespace {

// A signal handler can reach nothing but a global.
std::atomic<int> signalsSeen{0};
static_assert(std::atomic<int>::is_always_lock_free);

void onSignal(int) {
  if (signalsSeen.fetch_add(1) > 0) platform::endAtOnce(kCancelled);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signalsSeen = 0;
  platform::handleInterrupts(onSignal);
}
InterruptGuard::~InterruptGuard() { platform::leaveInterruptsToTheSystem(); }
bool InterruptGuard::asked() { return signalsSeen.load() > 0; }

}  // namespace squat::commands
