#include "core/platform/Process.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>

namespace squat::platform {

namespace {

std::string firstLine(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

// Empty where no such process runs.
std::string identityOf(const std::string& process) {
  constexpr std::size_t state = 0, start = 19;                       // of the fields behind the name
  const std::string stat = firstLine("/proc/" + process + "/stat");  // 1234 (its name) S ...
  const auto name = stat.rfind(')');
  if (name == std::string::npos) return {};
  std::istringstream rest(stat.substr(name + 1));
  std::array<std::string, start + 1> fields;
  for (auto& field : fields)
    if (!(rest >> field)) return {};
  if (fields[state] == "Z" || fields[state] == "X") return {};  // has ended; nobody has asked yet how
  return process + "-" + fields[start] + "-" + firstLine("/proc/sys/kernel/random/boot_id").substr(0, 8);
}

}  // namespace

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
