// solver/core/platform/Process.h - who this process is, which others there are, and how it ends.
#pragma once

#include <string>

namespace squat::platform {

long processNumber();    // of this process
std::string hostName();  // of this machine, at most 64 bytes; empty: not known

// "OWNER (process 4711 on HOST)", at most 200 bytes.
std::string processName(const std::string& owner);

// Whether a process of this machine has the number; true where that is not known.
bool isRunning(long number);

// Whether the process of that number, start and boot ("4711-8123456-1a2b3c4d") is still there: numbers of processes
// come back, these do not.
bool isAlive(const std::string& identity);

// Nothing is destroyed, nothing that was printed is flushed: for handlers of signals.
[[noreturn]] void endAtOnce(int code);

}  // namespace squat::platform
