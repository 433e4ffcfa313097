// solver/core/platform/posix/System.h - what Linux and macOS do in different ways, for the sources that both share.
#pragma once

#include <cstddef>
#include <string>

namespace squat::platform {

char** environmentOfProcess();

// A pair of connected sockets. Programs that this process starts do not inherit them unless told to, and sending to a
// socket whose other end is closed does not end this process. Returns 0, or an error number.
int pairOfSockets(int (&ends)[2]);

// Waits until the bytes of the file are on the disk. Returns 0, or -1 with errno.
int flushToDisk(int file);

std::size_t addressSpaceNow();  // [bytes] of this process; 0: not known

// "4711-START-BOOT" of the running process with this number; empty where there is none.
std::string identityOf(const std::string& process);

}  // namespace squat::platform
