#include "core/platform/posix/System.h"

#include <crt_externs.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/sysctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace squat::platform {

char** environmentOfProcess() { return *::_NSGetEnviron(); }

// Between the call and the mark a program that another thread starts may inherit the ends: it keeps them open, and this
// process waits for its answer until that program has ended as well.
int pairOfSockets(int (&ends)[2]) {
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return errno;
  const int yes = 1;
  for (const int end : ends) {
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
    ::setsockopt(end, SOL_SOCKET, SO_NOSIGPIPE, &yes, sizeof yes);
  }
  return 0;
}

// fsync() leaves the bytes in the memory of the drive. Where a file system has no F_FULLFSYNC, it is all there is.
int flushToDisk(int file) { return ::fcntl(file, F_FULLFSYNC) == 0 ? 0 : ::fsync(file); }

// Not needed: macOS does not enforce a limit of the address space.
std::size_t addressSpaceNow() { return 0; }

std::string identityOf(const std::string& process) {
  int question[] = {CTL_KERN, KERN_PROC, KERN_PROC_PID, static_cast<int>(std::strtol(process.c_str(), nullptr, 10))};
  kinfo_proc found{};
  std::size_t size = sizeof found;
  if (::sysctl(question, 4, &found, &size, nullptr, 0) != 0 || size == 0) return {};
  if (found.kp_proc.p_stat == SZOMB) return {};  // has ended; nobody has asked yet how
  int bootQuestion[] = {CTL_KERN, KERN_BOOTTIME};
  timeval boot{};
  size = sizeof boot;
  if (::sysctl(bootQuestion, 2, &boot, &size, nullptr, 0) != 0) return {};
  const auto& start = found.kp_proc.p_starttime;
  return process + "-" + std::to_string(start.tv_sec) + std::to_string(start.tv_usec) + "-" +
         std::to_string(boot.tv_sec);
}

}  // namespace squat::platform
