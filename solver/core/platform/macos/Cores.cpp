#include "core/platform/Cores.h"

#include <sys/sysctl.h>

#include <cstddef>
#include <cstdint>

namespace squat::platform {

int usableCores() {
  int cores = 0;
  std::size_t size = sizeof cores;
  return ::sysctlbyname("hw.activecpu", &cores, &size, nullptr, 0) == 0 ? cores : 0;
}

// Apple's own processors have none of the third level that programs could ask for.
double lastLevelCache() {
  std::int64_t bytes = 0;
  std::size_t size = sizeof bytes;
  return ::sysctlbyname("hw.l3cachesize", &bytes, &size, nullptr, 0) == 0 ? static_cast<double>(bytes) : 0.0;
}

}  // namespace squat::platform
