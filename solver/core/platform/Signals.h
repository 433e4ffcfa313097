// solver/core/platform/Signals.h - what the system tells a process to stop it, or to keep it from going on.
#pragma once

namespace squat::platform {

// Calls `handler` for Ctrl-C and for the wish that the process ends; what they interrupt goes on afterwards. The
// handler may reach nothing but atomics and endAtOnce() (Process.h).
void handleInterrupts(void (*handler)(int));
// They end the process again.
void leaveInterruptsToTheSystem();

// Of this process: what goes beyond the limit of file size is an error of writing, not the end of the process.
void ignoreFileSizeSignal();
// Writing to a pipe that nobody reads ends the process, whatever its parent has set.
void endWhereAPipeIsClosed();

// The same as ignoreFileSizeSignal() for the calling thread while this lives: for libraries, which must not change what
// belongs to the process.
class FileSizeSignalBlocked {
 public:
  FileSizeSignalBlocked();
  ~FileSizeSignalBlocked();
  FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
  FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;

 private:
  bool wasBlocked_ = false;  // by somebody else, who takes the signal
};

}  // namespace squat::platform
