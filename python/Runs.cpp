#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <string>
#include <utility>

#include "case/Resolve.h"
#include "core/Errors.h"
#include "core/platform/Memory.h"
#include "python/Arrays.h"
#include "python/Case.h"
#include "python/Computation.h"
#include "python/Errors.h"
#include "python/Module.h"
#include "python/Results.h"
#include "results/ResultFile.h"
#include "results/SignalTable.h"
#include "simulation/RunCase.h"

namespace squat::python {

namespace py = pybind11;

namespace {

using results::RunResult;
using Scalars = std::vector<results::Scalar>;

std::shared_ptr<RunResult> run(const Case& which, int threads, const py::object& progress, bool fields) {
  requireThreads(threads);
  simulation::RunOptions options;
  options.threads = threads, options.snapshots = fields;
  const auto description = which.description;  // Python may change the case while its lock is released
  const auto stem = which.stem;
  auto result = std::make_shared<RunResult>(), partial = std::make_shared<RunResult>();
  try {
    computeAside(progress, [&](Monitor& monitor) {
      *result = simulation::runCase(description, options, monitor, partial.get());
    });
  } catch (const RunError& error) {
    partial->stem = stem;
    const auto exception = exceptionOf(error);
    if (!partial->time.empty()) exception.attr("partial") = partial;
    raise(exception);
  }
  result->stem = stem;
  platform::giveBackFreeMemory();  // a loop over many runs does not grow
  return result;
}

std::shared_ptr<RunResult> readResult(const std::filesystem::path& path, bool fields) {
  const py::gil_scoped_release others;
  return std::make_shared<RunResult>(results::readResult(
      path.string(), fields ? results::ResultContent::everything : results::ResultContent::withoutFields));
}

py::array signalOf(const py::object& self, const std::string& name) {
  const auto& result = self.cast<const RunResult&>();
  if (name == "time") return view(result.time, self);
  if (name == "position") return view(result.position, self);
  if (const auto* values = result.signal(name)) return view(*values, self);
  std::string names = "time, position";
  for (const auto& channel : result.signals) names += ", " + channel.name;
  throw py::key_error("'" + name + "' is no signal of this result; it has " + names);
}

std::vector<std::string> namesOf(const RunResult& result) {
  std::vector<std::string> names{"time", "position"};
  for (const auto& channel : result.signals) names.push_back(channel.name);
  return names;
}

template <typename Named>
void addUnits(py::dict& units, const std::string& group, const std::vector<Named>& all) {
  for (const auto& one : all) units[(group + one.name).c_str()] = one.unit;
}

py::dict unitsOf(const RunResult& result) {
  py::dict units;
  units["time"] = "s", units["position"] = "m";
  addUnits(units, "", result.signals);
  units["frequency"] = "Hz", units["psd"] = "(m/s2)2/Hz", units["psd_wheel"] = "(m/s2)2/Hz";
  units["scalogram"] = "(m/s2)2 s", units["scalogram_frequency"] = "Hz", units["scalogram_time"] = "s";
  units["scalogram_position"] = "m", units["cone_of_influence"] = "Hz";
  addUnits(units, "energy/", result.energy);
  addUnits(units, "features/", result.features), addUnits(units, "equilibrium/", result.equilibrium);
  addUnits(units, "mesh/", result.meshFigures), addUnits(units, "performance/", result.performance);
  addUnits(units, "plasticity/", result.plasticity);
  return units;
}

py::dict energyOf(const py::object& self) {
  const auto& result = self.cast<const RunResult&>();
  py::dict energy;
  energy["time"] = view(result.energyTime, self);
  for (const auto& channel : result.energy) energy[channel.name.c_str()] = view(channel.values, self);
  return energy;
}

py::dict profileOf(const py::object& self) {
  const auto& result = self.cast<const RunResult&>();
  py::dict profile;
  profile["position"] = view(result.profilePosition, self), profile["height"] = view(result.profileHeight, self);
  profile["wheel_path"] = view(result.wheelPath, self);
  return profile;
}

py::dict modesOf(const py::object& self) {
  const auto& modes = self.cast<const RunResult&>().modes;
  py::dict all;
  all["frequency"] = viewOfMember(modes, &results::WheelsetMode::frequency, self);
  all["box_share"] = viewOfMember(modes, &results::WheelsetMode::boxAmplitude, self);
  all["wheel_share"] = viewOfMember(modes, &results::WheelsetMode::wheelAmplitude, self);
  all["contact_share"] = viewOfMember(modes, &results::WheelsetMode::contactAmplitude, self);
  return all;
}

void addArray(ResultClass& type, const char* name, std::vector<double> RunResult::*member, const char* doc) {
  type.def_property_readonly(
      name, [member](const py::object& self) { return view(self.cast<const RunResult&>().*member, self); }, doc);
}

void addScalars(ResultClass& type, const char* name, Scalars RunResult::*member, const char* doc) {
  type.def_property_readonly(
      name,
      [member](const RunResult& self) {
        py::dict values;
        for (const auto& scalar : self.*member) values[scalar.name.c_str()] = scalar.value;
        return values;
      },
      doc);
}

template <typename T>
void addText(ResultClass& type, const char* name, T RunResult::*member, const char* doc) {
  type.def_property_readonly(
      name, [member](const RunResult& self) { return self.*member; }, doc);
}

void addSignals(ResultClass& type) {
  type.def("__getitem__", &signalOf, py::arg("name"), "A signal by its name: array (n).")
      .def("__contains__",
           [](const RunResult& self, const std::string& name) {
             return name == "time" || name == "position" || self.signal(name) != nullptr;
           })
      .def("keys", &namesOf, "time, position and the names of all signals: a list of str.")
      .def("__iter__", [](const RunResult& self) { return py::iter(py::cast(namesOf(self))); })
      .def("__len__", [](const RunResult& self) { return self.signals.size() + 2; })
      .def_property_readonly("units", &unitsOf,
                             "Units: a dict of name and unit. Signals and spectra by their names, numbers of dicts as "
                             "features/peak.");
  addArray(type, "time", &RunResult::time, "Time since the start of rolling [s]: array (n).");
  addArray(type, "position", &RunResult::position,
           "Position of the wheel centre from the deepest point of the defect [m]: array (n).");
}

void addSpectra(ResultClass& type) {
  addArray(type, "frequency", &RunResult::frequency, "Frequencies of psd and psd_wheel [Hz]: array (f).");
  addArray(type, "psd", &RunResult::psd, "Power spectral density of aba_filtered [(m/s2)2/Hz]: array (f).");
  addArray(type, "psd_wheel", &RunResult::psdWheel, "The same of the wheel centre [(m/s2)2/Hz]: array (f), or empty.");
  type.def_property_readonly(
      "scalogram",
      [](const py::object& self) {
        const auto& result = self.cast<const RunResult&>();
        return viewOfRows(result.scalogramPower, result.scalogramTime.size(), self);
      },
      "Wavelet power of aba_filtered [(m/s2)2 s]: array (F, T), one row a frequency.");
  addArray(type, "scalogram_frequency", &RunResult::scalogramFrequency, "Frequencies of its rows [Hz]: array (F).");
  addArray(type, "scalogram_time", &RunResult::scalogramTime, "Times of its columns [s]: array (T).");
  addArray(type, "scalogram_position", &RunResult::scalogramPosition, "Positions of its columns [m]: array (T).");
  addArray(type, "cone_of_influence", &RunResult::coneOfInfluence,
           "Lowest frequency that can be trusted at each of its columns [Hz]: array (T).");
}

void addFigures(ResultClass& type) {
  addScalars(type, "features", &RunResult::features,
             "Features of aba_filtered: a dict of name and number; units as units[\"features/peak\"].");
  addScalars(type, "equilibrium", &RunResult::equilibrium, "Numbers of the equilibrium: a dict of name and number.");
  addScalars(type, "mesh", &RunResult::meshFigures, "Numbers of mesh and time step: a dict of name and number.");
  addScalars(type, "performance", &RunResult::performance, "Steps, seconds, memory: a dict of name and number.");
  addScalars(type, "plasticity", &RunResult::plasticity,
             "Numbers of a rail that yields: a dict of name and number; else empty.");
  type.def_property_readonly("energy", &energyOf,
                             "Energies over time: a dict of time [s] and one array (e) [J] for each term.")
      .def_property_readonly("profile", &profileOf,
                             "The defect and the path of a rigid wheel over it: a dict of position, height and "
                             "wheel_path [m], arrays (p).")
      .def_property_readonly(
          "modes", &modesOf,
          R"(Natural modes of the half wheelset: a dict of frequency [Hz] and of box_share, wheel_share and
contact_share [1/sqrt(kg)], arrays (m).)");
}

void addFacts(ResultClass& type) {
  type.def_property_readonly(
      "case", [](const RunResult& self) { return caseOf(results::caseOf(self).description, self.stem); },
      "The case, every key filled in: a squat.Case. Raises FileError where the result has none.");
  addText<bool>(type, "complete", &RunResult::complete, "Whether the run came to its end: bool.");
  addText<std::string>(type, "stop_reason", &RunResult::stopReason, "\"done\", \"cancelled\" or \"failed: ...\": str.");
  addText<std::string>(type, "title", &RunResult::title, "Title of the case: str.");
  addText<std::string>(type, "name", &RunResult::stem, "Name of the case: str.");
  addText<std::string>(type, "case_hash", &RunResult::caseHash, "Hash of the case, as Case.hash: str.");
  addText<std::string>(type, "created", &RunResult::created, "When it was made, UTC, ISO 8601: str.");
  addText<std::string>(type, "version", &RunResult::codeVersion, "Version of the program that made it: str.");
  addText<std::vector<std::string>>(type, "warnings", &RunResult::warnings, "Warnings of the run: a list of str.");
  addText<double>(type, "speed", &RunResult::speed, "Speed [m/s]: float.");
  addText<int>(type, "threads", &RunResult::threads, "Threads that computed it: int.");
  type.def("__repr__", [](const RunResult& self) {
    return "<squat.Result " + self.stem + ", " + std::to_string(self.time.size()) + " samples, " + self.stopReason +
           ">";
  });
}

}  // namespace

void addRuns(py::module_& module) {
  ResultClass type(
      module, "Result",
      R"(What a run yields, in SI units. All arrays are read-only and show the memory of the result: nothing
is copied, and an array keeps its result alive. result["aba_filtered"] is a signal; dict(result) has
all of them, for pandas.)");
  addSignals(type);
  addSpectra(type);
  addFigures(type);
  addFacts(type);
  type.def(
          "save",
          [](const RunResult& self, const std::filesystem::path& path) {
            const py::gil_scoped_release others;
            results::writeResult(path.string(), self);
          },
          py::arg("path"),
          R"(Write the result file (HDF5), as the command run does; an earlier file stays until the new one is
whole. Raises FileError.)")
      .def(
          "save_signals",
          [](const RunResult& self, const std::filesystem::path& path) {
            const py::gil_scoped_release others;
            results::writeSignalTable(path.string(), self);
          },
          py::arg("path"), "Write all signals as CSV, a column each. Raises FileError.");
  addFields(type);

  module.def("run", &run, py::arg("case"), py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("fields") = true,
             R"(Run a case: mesh, equilibrium, rolling over the defect, spectra. Returns a Result.

`threads`: 0 for all cores; they do not change the numbers. `progress`: None, or a function that is
called several times a second with the phase (str) and its fraction (0 to 1); what it raises ends
the run and is raised here, as Ctrl-C is (KeyboardInterrupt). `fields`: keep surface, snapshots and
contact patches for pictures, which are most of a result's memory. Python's lock is released, so
that several threads can make runs at the same time.

Raises CaseError for a case that cannot be run, RunError for a run that failed.)");
  module.def("read_result", &readResult, py::arg("path"), py::arg("fields") = true,
             R"(Read a result file (HDF5). `fields`: with surface, snapshots and contact patches. Returns a Result.
Raises FileError.)");
}

}  // namespace squat::python
