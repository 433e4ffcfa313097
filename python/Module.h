// python/Module.h - the parts of the Python module: each adds its functions and classes.
#pragma once

#include <pybind11/pybind11.h>

namespace squat::python {

void addErrors(pybind11::module_& module);
void addCases(pybind11::module_& module);
void addRuns(pybind11::module_& module);
void addDetection(pybind11::module_& module);
void addEstimation(pybind11::module_& module);
void addReceptance(pybind11::module_& module);

}  // namespace squat::python
