// solver/core/platform/Memory.h - what the process has of the machine's memory, and how it holds it.
#pragma once

#include <cstddef>

namespace squat::platform {

double availableMemory();  // [bytes] that programs may still take on this machine; 0: not known
double peakMemory();       // [bytes] the largest resident size of this process so far; 0: not known

// Asks for large pages under memory that begins on such a page. A wish only: where the system has none, everything
// works with small ones.
void wishLargePages(void* begin, std::size_t bytes);

// To be called once, before the first run. Left to itself the C library takes ever larger arrays from a heap that only
// shrinks at its end, once arrays of their size have been given back: a study's memory grows by 0.4 MB a run
// (measured). With a fixed threshold large arrays come from the system and go back to it.
void keepMemorySteady();

// Between the runs of a study: rows that stay lie between what a run has given back, and pages of the heap that hold
// nothing more would stay with the process, some 15 kB a run (measured).
void giveBackFreeMemory();

}  // namespace squat::platform
