#include "core/platform/Cores.h"

#include <windows.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace squat::platform {

// A process belongs to one group of at most 64 cores, unless it asks for more.
int usableCores() {
  DWORD_PTR own = 0, all = 0;
  return ::GetProcessAffinityMask(::GetCurrentProcess(), &own, &all) ? std::popcount(std::uint64_t{own}) : 0;
}

double lastLevelCache() {
  DWORD bytes = 0;
  ::GetLogicalProcessorInformation(nullptr, &bytes);
  std::vector<SYSTEM_LOGICAL_PROCESSOR_INFORMATION> rows(bytes / sizeof(SYSTEM_LOGICAL_PROCESSOR_INFORMATION));
  if (rows.empty() || !::GetLogicalProcessorInformation(rows.data(), &bytes)) return 0;
  double sum = 0;
  for (const auto& row : rows)  // one for each cache, whoever shares it
    if (row.Relationship == RelationCache && row.Cache.Level == 3) sum += row.Cache.Size;
  return sum;
}

}  // namespace squat::platform
