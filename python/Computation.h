// python/Computation.h - long computations: without Python's lock, with progress, ended by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "core/Monitor.h"

namespace squat::python {

// Runs `work` on a thread of its own and waits for it, with Python's lock released. Meanwhile the calling thread looks
// for signals, calls `progress(phase, fraction)` where it is not None, and hands messages to the logger "squat": Python
// code runs in no other thread, and a slow one does not hold up the computation. Reports of one phase that come while
// Python is busy are combined into the latest.
//
// Ctrl-C and an exception of `progress` cancel `work` through its monitor; once it has returned, that exception is
// thrown. Python sees signals in its main thread only. Otherwise an exception of `work` is thrown.
void computeAside(const pybind11::object& progress, const std::function<void(Monitor&)>& work);

// Threads that a user asks for: 0, all cores, or at least 1. Throws CaseError.
void requireThreads(int threads);

// Throws CaseError where a value is beyond its range or not a number; `allowed` as it reads after "must be".
void requireBetween(const char* name, double value, double low, double high, const char* allowed);

}  // namespace squat::python
