#include "core/platform/Cores.h"

#include <sched.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

namespace squat::platform {

int usableCores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  return ::sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 0;
}

// Linux lists the caches of each core; those that cores share are counted once.
double lastLevelCache() {
  const std::filesystem::path folder("/sys/devices/system/cpu");
  std::map<std::string, double> sizes;  // by the cores that share it
  std::error_code none;
  for (const auto& core : std::filesystem::directory_iterator(folder, none)) {
    std::ifstream shared(core.path() / "cache/index3/shared_cpu_list"), file(core.path() / "cache/index3/size");
    std::string cores;
    double kibibytes = 0;
    if (shared >> cores && file >> kibibytes) sizes[cores] = 1024 * kibibytes;  // "32768K"
  }
  double sum = 0;
  for (const auto& [cores, size] : sizes) sum += size;
  return sum;
}

}  // namespace squat::platform
