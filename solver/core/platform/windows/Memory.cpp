#include "core/platform/Memory.h"

#include <windows.h>
// After <windows.h>, whose types it needs.
#include <psapi.h>

#include <malloc.h>
#include <algorithm>

namespace squat::platform {

// What is promised must have room in memory and paging file together.
double availableMemory() {
  MEMORYSTATUSEX state{};
  state.dwLength = sizeof state;
  if (!::GlobalMemoryStatusEx(&state)) return 0;
  return static_cast<double>(std::min(state.ullAvailPhys, state.ullAvailPageFile));
}

double peakMemory() {
  PROCESS_MEMORY_COUNTERS counters{};
  if (!::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters)) return 0;
  return static_cast<double>(counters.PeakWorkingSetSize);
}

// They need a right there that users seldom have.
void wishLargePages(void*, std::size_t) {}

// The heap of Windows takes large arrays from the system and gives them back by itself.
void keepMemorySteady() {}

void giveBackFreeMemory() { ::_heapmin(); }

}  // namespace squat::platform
