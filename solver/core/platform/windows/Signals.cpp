#include "core/platform/Signals.h"

#include <signal.h>
#include <windows.h>

#include <atomic>

namespace squat::platform {

namespace {

using Handler = void (*)(int);
std::atomic<Handler> interruptHandler{nullptr};

// Called in a thread of its own. Once it has returned from a closed window or the end of the session, Windows ends the
// process; while it waits, the program may write its checkpoint: some 5 s.
BOOL WINAPI onConsoleEvent(DWORD event) {
  const Handler handler = interruptHandler.load();
  if (!handler) return FALSE;
  const bool isWish = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
  handler(isWish ? SIGINT : SIGTERM);
  if (!isWish) ::Sleep(INFINITE);
  return TRUE;
}

}  // namespace

void handleInterrupts(Handler handler) {
  if (!interruptHandler.exchange(handler)) ::SetConsoleCtrlHandler(onConsoleEvent, TRUE);
}

void leaveInterruptsToTheSystem() {
  if (interruptHandler.exchange(nullptr)) ::SetConsoleCtrlHandler(onConsoleEvent, FALSE);
}

// Windows has no such signals: writing fails.
void ignoreFileSizeSignal() {}
void endWhereAPipeIsClosed() {}
FileSizeSignalBlocked::FileSizeSignalBlocked() = default;
FileSizeSignalBlocked::~FileSizeSignalBlocked() { static_cast<void>(wasBlocked_); }

}  // namespace squat::platform
