#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "case/ParameterValue.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/platform/OwnFolder.h"
#include "estimation/EstimateFiles.h"
#include "estimation/Estimation.h"
#include "python/Arrays.h"
#include "python/Case.h"
#include "python/Computation.h"
#include "python/Events.h"
#include "python/Module.h"
#include "python/Records.h"
#include "studies/Jobs.h"

namespace squat::python {

namespace py = pybind11;

namespace {

using estimation::Estimate;

// The library takes case and passages as files; those that stand in memory are written here.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto beginning = (std::filesystem::temp_directory_path() / "squat").string();
    path_ = platform::makeOwnFolder(beginning);
    if (path_.empty())
      throw FileError(beginning + "-XXXXXX", "", "cannot be made", "Set TMPDIR to a folder that can be written");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string passageFile(const py::object& passage, std::size_t index, const TemporaryFolder& folder) {
  const auto name = "passage-" + std::to_string(index + 1);
  const bool isEvent = py::isinstance<Event>(passage);
  if (!isEvent && !isArrays(passage)) return recordFile(textOf(passage));
  auto path = folder / (name + ".csv");
  writeDurably(path, std::string_view(isEvent ? detection::passageCsv(passage.cast<const Event&>().event())
                                              : csvOf(arrayRecord(name, passage))));
  return path;
}

std::vector<std::string> passageFiles(const py::object& passages, const TemporaryFolder& folder) {
  std::vector<std::string> files;
  if (py::isinstance<py::list>(passages) || py::isinstance<py::tuple>(passages))
    for (const auto& one : passages)
      files.push_back(passageFile(py::reinterpret_borrow<py::object>(one), files.size(), folder));
  else
    files.push_back(passageFile(passages, 0, folder));
  if (files.empty()) throw CaseError({{"passages", "an empty list", "at least one passage", ""}});
  return files;
}

std::shared_ptr<Estimate> estimate(const Case& which, const py::object& passages, double lowPass, double longest,
                                   int runs, int jobs, int threads, const py::object& progress,
                                   const py::kwargs& reading) {
  requireThreads(threads);
  requireBetween("low_pass", lowPass, 200, 5000, "200 to 5000 Hz");
  requireBetween("longest", longest, 20, 200, "20 to 200 mm");
  requireBetween("runs", runs, 20, 10000, "20 to 10000");
  requireBetween("jobs", jobs, 0, 256, "0 for as many as cores and memory allow, or 1 to 256");
  const TemporaryFolder folder;
  estimation::EstimateDefinition definition;
  definition.caseName = folder / (which.stem + ".toml");
  cases::saveCase(which.description, definition.caseName);
  definition.files = passageFiles(passages, folder);
  definition.reading = readingFrom(reading);
  definition.cutoff = lowPass, definition.longest = 1e-3 * longest;
  const auto mesh = cases::valueText(which.description, *cases::findParameter("mesh.preset"));
  const auto sharing = studies::shareMachine(studies::thisMachine(), studies::demandOnMesh(mesh), {jobs, threads});
  estimation::EstimateOptions options;
  options.jobs = sharing.jobs, options.threads = sharing.threads, options.runs = runs;
  auto found = std::make_shared<Estimate>();
  computeAside(progress, [&](Monitor& monitor) { *found = estimation::estimateProfile(definition, options, monitor); });
  return found;
}

py::tuple asTuple(const estimation::Interval& interval) {
  return py::make_tuple(interval.value, interval.low, interval.high);
}

py::dict estimatedProfile(const py::object& self) {
  const auto& profile = self.cast<const Estimate&>().profile;
  using estimation::ProfileSample;
  py::dict all;
  all["position"] = viewOfMember(profile, &ProfileSample::position, self);
  all["height"] = viewOfMember(profile, &ProfileSample::height, self);
  all["lower"] = viewOfMember(profile, &ProfileSample::lower, self);
  all["upper"] = viewOfMember(profile, &ProfileSample::upper, self);
  all["is_felt"] = viewOfMember(profile, &ProfileSample::isFelt, self);
  return all;
}

py::list explainedPassages(const py::object& self) {
  py::list all;
  for (const auto& passage : self.cast<const Estimate&>().passages) {
    py::dict one;
    one["name"] = passage.name, one["speed"] = passage.speed, one["location"] = passage.location;
    one["noise"] = passage.noise, one["difference"] = passage.difference, one["peak"] = passage.peak;
    one["position"] = view(passage.position, self);
    one["measured"] = view(passage.measured, self), one["computed"] = view(passage.computed, self);
    all.append(one);
  }
  return all;
}

void addEstimateClass(py::module_& module) {
  py::class_<Estimate, std::shared_ptr<Estimate>>(
      module, "Estimate", "The profile that explains measured passages. Arrays are read-only and not copied.")
      .def_property_readonly(
          "profile", &estimatedProfile,
          R"(A dict of position from the deepest sample, height, lower and upper [m], arrays (p) of float64, and
is_felt, array (p) of bool: False where the wheel bridges the rail, which may be deeper.)")
      .def_property_readonly(
          "depth", [](const Estimate& self) { return asTuple(self.depth); },
          "Depth [m]: a tuple of value, low and high of 90 %.")
      .def_property_readonly(
          "length", [](const Estimate& self) { return asTuple(self.length); },
          "Length between 5 % of the depth [m]: a tuple of value, low and high of 90 %.")
      .def_readonly("misfit", &Estimate::misfit, "Root mean square of all differences over the noise: float.")
      .def_readonly("depth_of_path", &Estimate::depthOfPath, "Depth of a rigid wheel's path over it [m]: float.")
      .def_property_readonly(
          "passages", &explainedPassages,
          R"(Each passage beside what the profile gives: a list of dicts with name, speed [m/s], location [m],
noise, difference and peak [m/s2], and arrays (n) of position [m], measured and computed [m/s2].)")
      .def_property_readonly(
          "case", [](const Estimate& self) { return caseOf(self.description, "estimate"); },
          "The case with the profile: a squat.Case.")
      .def_readonly("notes", &Estimate::notes, "What was assumed or is to be known: a list of str.")
      .def_readonly("runs", &Estimate::runs, "Runs that it took: int.")
      .def(
          "save",
          [](const Estimate& self, const std::filesystem::path& folder) {
            const py::gil_scoped_release others;
            makeFolder(folder.string());
            estimation::writeEstimate(self, folder.string());
            return estimation::estimateFiles(folder.string());
          },
          py::arg("folder"), "Write the files of the command estimate. Returns their paths. Raises FileError.");
}

}  // namespace

void addEstimation(py::module_& module) {
  addEstimateClass(module);
  module.def("estimate", &estimate, py::arg("case"), py::arg("passages"), py::kw_only(), py::arg("low_pass") = 2000.0,
             py::arg("longest") = 70.0, py::arg("runs") = 150, py::arg("jobs") = 0, py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             R"(Estimate the profile of a defect from measured passages over it.

`case`: vehicle, track and location, with the mesh of the runs; tiny is usual. Its own defect does
not count. `passages`: over one defect: a file, an Event of detect(), or arrays as in detect(); a
list of them. `low_pass` [Hz] of measured and computed signals. `longest` [mm] dip that is looked
for. `runs` after which the search ends, about. `jobs`: runs at once, 0: as many as cores and memory
allow; `threads` of each. `progress` and Ctrl-C as in run(); further arguments as in detect(). It
takes minutes.

Returns an Estimate. Raises CaseError for a case that cannot be run, FileError for passages without
an event, too short, or without a unit, RunError where no profile can be run.)");
}

}  // namespace squat::python
