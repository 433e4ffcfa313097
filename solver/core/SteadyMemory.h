// solver/core/SteadyMemory.h - a process that makes many runs does not grow with them.
#pragma once

#include <cstdlib>  // tells whether the C library is GNU's
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace squat {

// To be called once, before the first run. Left to itself the C library takes ever larger arrays from a heap that only
// shrinks at its end, once arrays of their size have been given back: a study's memory grows by 0.4 MB a run
// (measured). With a fixed threshold large arrays come from the system and go back to it.
inline void keepMemorySteady() {
#if defined(__GLIBC__)
  ::mallopt(M_MMAP_THRESHOLD, 128 * 1024);  // where it begins by itself
#endif
}

// Between the runs of a study: rows that stay lie between what a run has given back, and pages of the heap that hold
// nothing more would stay with the process, some 15 kB a run (measured).
inline void giveBackFreeMemory() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace squat
