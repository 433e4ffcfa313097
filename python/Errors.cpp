#include "python/Errors.h"

#include <algorithm>
#include <regex>
#include <string>

#include "python/Module.h"

namespace squat::python {

namespace py = pybind11;

namespace {

// The library's messages name options of the command line; here they are arguments of the same names, with underscores:
// "--wheel-diameter" is wheel_diameter, and "--set KEY=VALUE" is KEY=VALUE. What is within a word, as of a path, stays.
std::string inWordsOfPython(std::string text) {
  static const std::regex set(R"( \(--set\)|--set )"), option(R"((^|[^\w/.-])--([a-z]+)((?:-[a-z]+)*))");
  text = std::regex_replace(text, set, "");
  std::string result;
  std::smatch found;
  for (; std::regex_search(text, found, option); text = found.suffix()) {
    std::string rest = found.str(3);
    std::replace(rest.begin(), rest.end(), '-', '_');
    result += found.prefix().str() + found.str(1) + found.str(2) + rest;
  }
  return result + text;
}

py::object typeNamed(const char* name) { return py::module_::import("squat").attr(name); }

py::object ofCase(const CaseError& error) {
  std::vector<CaseProblem> problems;
  py::list members;
  for (const auto& problem : error.problems()) {
    problems.push_back({inWordsOfPython(problem.key), problem.value, problem.allowed, inWordsOfPython(problem.advice)});
    const auto& own = problems.back();
    py::dict member;
    member["key"] = own.key, member["value"] = own.value;
    member["allowed"] = own.allowed, member["advice"] = own.advice;
    members.append(member);
  }
  py::object exception = typeNamed("CaseError")(CaseError(std::move(problems)).what());
  exception.attr("problems") = members;
  return exception;
}

py::object ofFile(const FileError& error) {
  const std::string text = error.what();
  const auto path = text.starts_with(error.path()) ? error.path().size() : 0;  // stays as it is
  py::object exception = typeNamed("FileError")(text.substr(0, path) + inWordsOfPython(text.substr(path)));
  exception.attr("path") = error.path(), exception.attr("location") = error.location();
  return exception;
}

void setPending(const py::object& exception) { PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr()); }

void translate(std::exception_ptr error) {  // NOLINT(performance-unnecessary-value-param): pybind11 gives it so
  try {
    if (error) std::rethrow_exception(error);
  } catch (const CaseError& wrong) {
    setPending(ofCase(wrong));
  } catch (const RunError& failed) {
    setPending(python::exceptionOf(failed));
  } catch (const FileError& invalid) {
    setPending(ofFile(invalid));
  }
}

void addException(py::module_& module, const char* name, const char* doc, const py::object& base) {
  const std::string qualified = std::string("squat.") + name;
  module.attr(name) =
      py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(qualified.c_str(), doc, base.ptr(), nullptr));
}

}  // namespace

py::object exceptionOf(const RunError& error) {
  py::object exception = typeNamed("RunError")(error.what());
  exception.attr("step") = error.step(), exception.attr("time") = error.time();
  exception.attr("location") = error.location(), exception.attr("partial") = py::none();
  return exception;
}

void raise(const py::object& exception) {
  setPending(exception);
  throw py::error_already_set();
}

void addErrors(py::module_& module) {
  addException(module, "Error", "Base of the errors of this module.",
               py::reinterpret_borrow<py::object>(PyExc_Exception));
  const py::object base = module.attr("Error");
  addException(
      module, "CaseError",
      "Invalid case or argument. `problems` is a list of dicts with key, value, allowed and advice: every problem that "
      "was found, not only the first.",
      base);
  addException(
      module, "RunError",
      "Failed run: `step`, `time` [s] simulated, `location` in the model; `partial` is the Result so far, or None.",
      base);
  addException(module, "FileError",
               "File that cannot be read or written, or holds something else: `path`, and `location` (line or object).",
               base);
  py::register_exception_translator(&translate);
}

}  // namespace squat::python
