// The solver as a Python module. What users import is the package squat (squat/__init__.py), which takes all names from
// here.
#include "python/Module.h"

#include "core/ProgramVersion.h"

PYBIND11_MODULE(_solver, module) {
  using namespace squat::python;
  const pybind11::object ownName = module.attr("__name__");
  module.attr("__name__") = "squat";  // under which docstrings name classes: where users find them
  module.attr("__version__") = squat::programVersion();
  addErrors(module);
  addCases(module);
  addRuns(module);
  addDetection(module);
  addEstimation(module);
  addReceptance(module);
  module.attr("__name__") = ownName;
}
