// Values of keys: objects of Python and the texts of the case file.
#include <string>

#include "case/ParameterValue.h"
#include "case/SeatsText.h"
#include "core/Errors.h"
#include "python/Case.h"

namespace squat::python {

namespace py = pybind11;

namespace {

py::object fromJson(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

std::string reprOf(const py::handle& value) { return py::repr(value).cast<std::string>(); }

std::string listText(const py::handle& list) {
  std::string text;
  for (const auto& item : py::reinterpret_borrow<py::sequence>(list)) text += (text.empty() ? "" : ", ") + textOf(item);
  return "[" + text + "]";
}

// { sleeper = 1, pad_stiffness = 300 }
std::string tableText(const py::dict& table) {
  std::string text;
  for (const auto& [key, value] : table)
    text += (text.empty() ? "" : ", ") + key.cast<std::string>() + " = " + textOf(value);
  return "{ " + text + " }";
}

py::list seatsOf(const std::vector<cases::Seat>& seats) {
  py::list list;
  for (const auto& seat : seats) {
    py::dict table;
    for (const auto& [key, text] : cases::seatEntries(seat)) table[key.c_str()] = fromJson(text);
    list.append(table);
  }
  return list;
}

}  // namespace

std::string textOf(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::dict>(value)) return tableText(py::reinterpret_borrow<py::dict>(value));
  if (py::hasattr(value, "tolist")) return textOf(value.attr("tolist")());  // arrays and numbers of NumPy
  if (py::hasattr(value, "__fspath__")) return textOf(value.attr("__fspath__")());
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) return listText(value);
  if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr())) return reprOf(value);
  throw py::type_error("a value of a case is a number, a text, a bool, a list or an array, not " + reprOf(value));
}

py::object valueFrom(const std::string& text, const cases::Parameter& parameter) {
  switch (parameter.kind) {
    case cases::Kind::number: {
      const py::float_ number{py::str(text)};  // Python's own reader knows no locale
      return parameter.integer ? py::object(py::int_(number)) : py::object(number);
    }
    case cases::Kind::boolean:
      return py::bool_(text == "true");
    case cases::Kind::choice:
    case cases::Kind::text:
      return py::str(text);
    case cases::Kind::points:
    case cases::Kind::lines:
    case cases::Kind::forceCurve:
      return fromJson(text);
    case cases::Kind::seats:
      break;
  }
  return seatsOf(cases::parseSeats(text).seats);
}

py::object valueOf(const cases::CaseDescription& description, const cases::Parameter& parameter) {
  if (parameter.kind != cases::Kind::number) return valueFrom(cases::valueText(description, parameter), parameter);
  const py::float_ number(cases::numberInUnit(description, parameter));
  return parameter.integer ? py::object(py::int_(number)) : py::object(number);
}

}  // namespace squat::python
