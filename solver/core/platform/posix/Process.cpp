#include "core/platform/Process.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "core/platform/posix/System.h"

namespace squat::platform {

long processNumber() { return ::getpid(); }

std::string hostName() {
  std::array<char, 128> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = 0;
  return std::string(host.data()).substr(0, 64);
}

std::string processName(const std::string& owner) {
  return owner.substr(0, 100) + " (process " + std::to_string(processNumber()) + " on " + hostName() + ")";
}

bool isRunning(long number) { return ::kill(static_cast<pid_t>(number), 0) == 0 || errno != ESRCH; }

bool isAlive(const std::string& identity) { return identity == identityOf(identity.substr(0, identity.find('-'))); }

void endAtOnce(int code) { ::_exit(code); }

}  // namespace squat::platform
