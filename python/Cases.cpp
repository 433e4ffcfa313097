#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "case/NamedTables.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "case/Validation.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "python/Case.h"
#include "python/Module.h"

namespace squat::python {

namespace py = pybind11;

namespace {

constexpr std::size_t largestFile = 4'000'000;  // bytes, as CaseFile.h has it

const cases::Parameter& parameterNamed(const std::string& key) {
  if (const auto* parameter = cases::findParameter(key)) return *parameter;
  throw CaseError({cases::unknownKey(key)});
}

cases::CaseOverrides overridesOf(const std::optional<std::string>& mesh, const py::kwargs& values) {
  auto overrides = overridesFrom(values);
  if (!mesh) return overrides;
  if (values.contains("mesh.preset"))
    throw CaseError({{"mesh", *mesh, "", "mesh.preset is set as well; leave out one of them"}});
  overrides.preset = *mesh;
  return overrides;
}

Case loadCase(const std::filesystem::path& name, const std::optional<std::string>& mesh, const py::kwargs& values) {
  const auto path = cases::findCase(name.string());
  return caseFromText(readWholeFile(path.string(), largestFile), path.string(), path.parent_path(),
                      cases::caseStem(name.string()), overridesOf(mesh, values));
}

Case parseCase(const std::string& text, const std::filesystem::path& folder, const std::optional<std::string>& mesh,
               const py::kwargs& values) {
  return caseFromText(text, "the text of the case", folder, "case", overridesOf(mesh, values));
}

const char* nameOf(cases::Kind kind) {
  switch (kind) {
    case cases::Kind::number:
      return "number";
    case cases::Kind::choice:
      return "choice";
    case cases::Kind::text:
      return "text";
    case cases::Kind::boolean:
      return "boolean";
    case cases::Kind::points:
      return "points";
    case cases::Kind::lines:
      return "lines";
    case cases::Kind::forceCurve:
      return "force curve";
    case cases::Kind::seats:
      return "seats";
  }
  return "";
}

py::dict rowOf(const cases::Parameter& parameter) {
  py::dict row;
  row["unit"] = parameter.unit, row["kind"] = nameOf(parameter.kind);
  row["default"] = valueFrom(cases::defaultTextOf(parameter), parameter);
  if (parameter.kind == cases::Kind::number) row["minimum"] = parameter.minimum, row["maximum"] = parameter.maximum;
  if (parameter.kind == cases::Kind::choice) row["choices"] = parameter.choices;
  row["doc"] = parameter.doc, row["source"] = parameter.source;
  return row;
}

py::dict parameters() {
  py::dict rows;
  for (const auto& parameter : cases::parameterTable()) rows[parameter.key.c_str()] = rowOf(parameter);
  return rows;
}

std::vector<std::string> keys() {
  std::vector<std::string> all;
  for (const auto& parameter : cases::parameterTable()) all.push_back(parameter.key);
  return all;
}

std::vector<std::string> warningsOf(const Case& which) {
  std::vector<std::string> lines;
  for (const auto& problem : cases::validate(which.description).warnings) lines.push_back(toWarning(problem));
  return lines;
}

}  // namespace

Case caseFromText(std::string text, std::string origin, std::filesystem::path folder, std::string stem,
                  cases::CaseOverrides overrides) {
  auto description = cases::parseCase(text, origin, folder, overrides);
  return {std::move(text), std::move(origin),    std::move(folder),
          std::move(stem), std::move(overrides), std::move(description)};
}

Case caseOf(const cases::CaseDescription& description, const std::string& stem) {
  return caseOfWritten(cases::writeCase(description), stem);
}

Case caseOfWritten(std::string toml, const std::string& stem) {
  // The text holds the numbers of all tables; where they are from may be gone, and is not to be opened.
  cases::CaseOverrides unnamed;
  for (const auto& table : cases::namedTables()) unnamed.values.emplace_back(table.fileKey, "");
  return caseFromText(std::move(toml), "the case of " + stem, {}, stem, std::move(unnamed));
}

cases::CaseOverrides overridesFrom(const py::dict& values) {
  cases::CaseOverrides overrides;
  for (const auto& [key, value] : values) overrides.values.emplace_back(key.cast<std::string>(), textOf(value));
  return overrides;
}

void setKeys(Case& which, const py::dict& values) {
  auto overrides = which.overrides;
  for (auto& set : overridesFrom(values).values) {
    if (set.first == "mesh.preset") overrides.preset.clear();
    std::erase_if(overrides.values, [&](const auto& earlier) { return earlier.first == set.first; });
    overrides.values.push_back(std::move(set));
  }
  which = caseFromText(which.text, which.origin, which.folder, which.stem, std::move(overrides));
}

void addCases(py::module_& module) {
  py::class_<Case>(module, "Case",
                   R"(A case: what is simulated, as keys and values.

case["defect.depth"] is a number in the unit of the case file (squat.parameters() lists the units),
a text, a bool or a list; an assignment takes the same, or a text with a unit ("108 km/h"), and
raises CaseError for an unknown key, a wrong value, and for values that do not go together. A case
is a mapping: dict(case) has every key. Of a whole model (model.extent) case["right.defect.depth"]
is the value of the right side, which is that of the left one unless it is set; dict(case) lacks these.)")
      .def("__getitem__",
           [](const Case& self, const std::string& key) {
             const auto right = cases::keyOnRight(key);
             if (right.empty() || !cases::mayDiffer(right)) return valueOf(self.description, parameterNamed(key));
             return valueOf(cases::rightOf(self.description), *cases::findParameter(right));
           })
      .def("__setitem__",
           [](Case& self, const std::string& key, const py::object& value) {
             py::dict one;
             one[key.c_str()] = value;
             setKeys(self, one);
           })
      .def("update", &setKeys, py::arg("values"),
           R"(Set several keys at once, all or none: for values that only together make a case. `values`: dict of
key and value. Raises CaseError.)")
      .def("__contains__", [](const Case&, const std::string& key) { return cases::findOnEitherSide(key) != nullptr; })
      .def(
          "keys", [](const Case&) { return keys(); }, "Every key, in the order of the case file: a list of str.")
      .def("__iter__", [](const Case&) { return py::iter(py::cast(keys())); })
      .def("__len__", [](const Case&) { return cases::parameterTable().size(); })
      .def(
          "copy", [](const Case& self) { return self; }, "The same case once more, to be changed by itself.")
      .def(
          "toml", [](const Case& self) { return cases::writeCase(self.description); },
          "The case as the text of a case file, every key filled in, with units and documentation as comments.")
      .def(
          "save", [](const Case& self, const std::filesystem::path& path) { cases::saveCase(self.description, path); },
          py::arg("path"), "Write the case as a TOML file. Raises FileError.")
      .def("warnings", &warningsOf, "What should be known before the case is run: a list of str.")
      .def_property_readonly(
          "name", [](const Case& self) { return self.stem; }, "Name of its results: str.")
      .def_property_readonly(
          "hash", [](const Case& self) { return cases::caseHash(self.description); },
          "Eight hexadecimal digits that stand for everything that the physics sees: str.")
      .def(py::pickle(  // for multiprocessing and copy
          [](const Case& self) { return py::make_tuple(cases::writeCase(self.description), self.stem); },
          [](const py::tuple& state) {
            return caseOfWritten(state[0].cast<std::string>(), state[1].cast<std::string>());
          }))
      .def("__repr__", [](const Case& self) {
        return "<squat.Case " + self.stem + ", mesh " +
               cases::valueText(self.description, parameterNamed("mesh.preset")) + ">";
      });

  module.def("load_case", &loadCase, py::arg("name"), py::arg("mesh") = py::none(),
             R"(Read a case: a shipped one by its name ("light-defect", see squat.shipped_cases()), or a case file
(TOML) by its path.

`mesh`: tiny, draft, standard or paper; None: as the case states, else draft. Further arguments set
keys, in the unit of the case file or with a unit: load_case("light-defect", mesh="tiny",
**{"defect.depth": 0.15}).

Raises CaseError with all wrong keys and values, FileError for a file that cannot be read or is no
TOML.)");
  module.def("parse_case", &parseCase, py::arg("text"), py::arg("folder") = "", py::arg("mesh") = py::none(),
             R"(Read a case from the text of a case file (TOML).

`folder`: where files that the case names are looked for. `mesh` and further arguments as in
load_case. Raises CaseError, FileError.)");
  module.def("shipped_cases", &cases::shippedCases, "Names of the cases that come with the program: a list of str.");
  module.def("parameters", &parameters,
             R"(Every key of a case: a dict of dicts with unit, kind, default, doc and source; of numbers minimum
and maximum, of choices their names. Default, minimum and maximum are in the unit.)");
}

}  // namespace squat::python
