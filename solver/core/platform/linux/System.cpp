#include "core/platform/posix/System.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
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

}  // namespace

char** environmentOfProcess() { return environ; }

int pairOfSockets(int (&ends)[2]) {
  return ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0 ? 0 : errno;
}

int flushToDisk(int file) { return ::fsync(file); }

std::size_t addressSpaceNow() {
  unsigned long pages = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

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

}  // namespace squat::platform
