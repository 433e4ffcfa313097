// python/Errors.h - the errors of the library as exceptions of Python.
#pragma once

#include <pybind11/pybind11.h>

#include "core/Errors.h"

namespace squat::python {

// squat.RunError, with its members.
pybind11::object exceptionOf(const RunError& error);

// Leaves the function that Python has called with this exception.
[[noreturn]] void raise(const pybind11::object& exception);

}  // namespace squat::python
