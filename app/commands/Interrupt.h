// app/commands/Interrupt.h - Ctrl-C and SIGTERM while a run goes on.
#pragma once

namespace squat::commands {

// While it lives, the first SIGINT or SIGTERM only sets a flag; a second one ends the program at once with code 130
// (safe: no file is ever half-written under its final name). One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  static bool asked();
};

}  // namespace squat::commands
