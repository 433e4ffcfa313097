#include "core/platform/Memory.h"

#include <mach/mach.h>
#include <sys/resource.h>

namespace squat::platform {

double availableMemory() {
  vm_statistics64 statistics{};
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  const auto asked =
      ::host_statistics64(::mach_host_self(), HOST_VM_INFO64, reinterpret_cast<host_info64_t>(&statistics), &count);
  if (asked != KERN_SUCCESS) return 0;
  const auto pages = static_cast<double>(statistics.free_count) + static_cast<double>(statistics.inactive_count);
  return pages * static_cast<double>(vm_kernel_page_size);
}

double peakMemory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss);  // bytes; Linux counts kibibytes
}

// Large pages are not for programs; the C library gives large arrays back by itself.
void wishLargePages(void* /*begin*/, std::size_t /*bytes*/) {}
void keepMemorySteady() {}
void giveBackFreeMemory() {}

}  // namespace squat::platform
