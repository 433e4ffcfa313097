// solver/core/platform/posix/System.h - what Linux and macOS do in different ways, for the sources that both share.
#pragma once

#include <cstddef>
#include <string>

namespace squat::platform {

char** environmentOfProcess();

// Two sockets that speak to each other; a program that this process starts inherits neither unless told to, and what is
// sent to one whose other end is gone ends no process. 0, or an error number.
int pairOfSockets(int (&ends)[2]);

// Until the bytes of the file are on the disk. 0, or -1 with errno.
int flushToDisk(int file);

std::size_t addressSpaceNow();  // [bytes] of this process; 0: not known

// "4711-START-BOOT" for a number that is alive; else empty.
std::string identityOf(const std::string& process);

}  // namespace squat::platform
