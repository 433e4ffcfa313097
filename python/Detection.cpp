#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "analysis/OptionText.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "detection/Detect.h"
#include "detection/ExampleSource.h"
#include "python/Case.h"
#include "python/Computation.h"
#include "python/Events.h"
#include "python/Module.h"
#include "python/Records.h"
#include "studies/Jobs.h"
#include "text/Csv.h"

namespace squat::python {

namespace py = pybind11;

namespace {

// Files, whose rides are found as on the command line, or arrays, each a pass by itself.
struct Search {
  std::vector<std::string> files;
  std::vector<ArrayRecord> arrays;
  records::RecordOptions reading;
  records::Together together = records::Together::asTheyFollow;
  detection::DetectOptions options;
  detection::SourceOptions source;
};

void addRecord(Search& search, const py::object& record) {
  if (isArrays(record))
    search.arrays.push_back(arrayRecord("record " + std::to_string(search.arrays.size() + 1), record));
  else
    search.files.push_back(recordFile(textOf(record)));
}

void takeRecords(Search& search, const py::object& record) {
  if (py::isinstance<py::list>(record) || py::isinstance<py::tuple>(record))
    for (const auto& one : record) addRecord(search, py::reinterpret_borrow<py::object>(one));
  else
    addRecord(search, record);
  if (search.files.empty() == search.arrays.empty())
    throw CaseError({{"record", search.files.empty() ? "an empty list" : "files and arrays",
                      "a file, arrays, or a list of either", ""}});
  search.files = records::inNumberOrder(std::move(search.files));
}

// Nothing where it was cancelled.
std::optional<std::vector<detection::RecordDetection>> candidates(const Search& search, Monitor& monitor) {
  std::vector<detection::RecordDetection> found;
  for (auto rest = search.files; !rest.empty();) {
    const auto stream = records::openRide(rest, search.reading, search.together);
    found.push_back(detection::findCandidates(*stream, search.options, monitor));
    if (found.back().cancelled) return std::nullopt;
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(stream->layout().files.size()));
  }
  for (const auto& arrays : search.arrays) {
    const auto stream = openArrays(arrays, search.reading);
    found.push_back(detection::findCandidates(*stream, search.options, monitor));
    if (found.back().cancelled) return std::nullopt;
  }
  return found;
}

std::optional<detection::DetectionReport> found(const Search& search, Monitor& monitor) {
  auto records = candidates(search, monitor);
  if (!records) return std::nullopt;
  const auto source = detection::exampleSource(search.source, *records, monitor);
  return source ? detection::judged(*std::move(records), *source, search.options, monitor) : std::nullopt;
}

void checkOptions(const detection::DetectOptions& options, const std::optional<double>& diameter) {
  requireThreads(options.threads);
  requireBetween("threshold", options.threshold, 1, 1e6, "1 to 1000000");
  requireBetween("false_alarms", options.falseAlarms, 1e-6, 100, "0.000001 to 100 a kilometre");
  requireBetween("least_share", options.leastShare, 0, 1, "0 to 1");
  if (diameter) requireBetween("wheel_diameter", *diameter, 0.3, 1.5, "0.3 to 1.5 m");
}

// A tuple of two names, a list of such tuples, or None.
detection::AxleNames axlesFrom(const py::object& axle) {
  if (axle.is_none()) return std::nullopt;
  const py::list all = py::isinstance<py::tuple>(axle) ? py::list(py::make_tuple(axle)) : py::list(axle);
  std::vector<std::string> texts;
  for (const auto& one : all) {
    if (!py::isinstance<py::tuple>(one) || py::len(one) != 2)
      throw CaseError({{"axle", textOf(py::str(one)), "a tuple of the left and the right channel, or a list", ""}});
    const auto names = py::reinterpret_borrow<py::tuple>(one);
    texts.push_back(text::csvField(textOf(names[0])) + "," + text::csvField(textOf(names[1])));
  }
  return texts.empty() ? detection::axleNamesFromText({"none"}) : detection::axleNamesFromText(texts);
}

constexpr const char* detectDoc =
    R"(Find squats, joints, welds, corrugation and wheel flats in records of axle box acceleration.

`record`: a file (text, HDF5, MATLAB and those of loggers; "example-record" is shipped), or arrays
in memory: a dict of heading and array (n), as {"time [s]": t, "aba [m/s2]": a}, or one array (n)
[m/s2] with `rate` [Hz]. float64 and float32 are read in place. A list of either: files that follow
on are one ride, others, and all arrays, are passes over one track, which are combined.

`case`: vehicle and track whose passages kinds and severities are judged by, computed once and kept
in `folder`; None: by general examples. `examples`, `labels`, `learned`: files as of the command
detect. `light`, `moderate`: largest length and depth of these severities [mm], "35x0.10".
`chainage` of the first sample, where the record has no positions: a number [m], "12.3 km" or
"12+300". `wheel_diameter` [m], None: found from the record. `threshold`: least evidence of an
event. `axle`: names of the left and the right channel of one wheelset, a tuple, or a list of them,
of which each event gets its side; []: none; None: channels whose names differ in left and right.
`false_alarms` [1/km] that are accepted from the background. `least_share` of the samples
that must be readable. `consecutive`: the files are one ride; `passes`: every file is a pass by
itself. `progress` and Ctrl-C as in run(). Further arguments say how records are read: speed [m/s]
(or "108 km/h") and rate [Hz] where the record has none, column, unit (of all signals, or a dict of
column and unit), time_column, position_column, speed_column, run_column, object, time_unit,
delimiter, decimal_comma, head_line.

Returns a Detection, a list of Event. Raises FileError for a record that cannot be read, CaseError
for arguments that do not fit, and where neither speed nor position is known.)";

}  // namespace

void addDetection(py::module_& module) {
  addEvents(module);
  module.def(
      "detect",
      [](const py::object& record, const std::optional<Case>& vehicle, const std::filesystem::path& folder,
         const std::filesystem::path& examples, const std::filesystem::path& labels,
         const std::filesystem::path& learned, const std::string& light, const std::string& moderate,
         const py::object& chainage, std::optional<double> diameter, double threshold, double falseAlarms,
         double leastShare, const py::object& axle, bool consecutive, bool passes, int threads,
         const py::object& progress, const py::kwargs& reading) {
        if (consecutive && passes)
          throw CaseError({{"passes", "True", "False where consecutive is True", "Files are one ride or several"}});
        Search search;
        search.together = consecutive ? records::Together::consecutive
                          : passes    ? records::Together::passes
                                      : records::Together::asTheyFollow;
        search.reading.columns = readingFrom(reading);
        search.reading.everyAcceleration = true;
        if (!chainage.is_none()) search.reading.chainage = analysis::chainageFromText(textOf(chainage));
        search.options.threshold = threshold, search.options.falseAlarms = falseAlarms;
        search.options.leastShare = leastShare, search.options.threads = threads;
        search.options.axles = axlesFrom(axle);
        checkOptions(search.options, diameter);
        if (diameter) search.options.surroundings.circumference = std::numbers::pi * *diameter;
        auto& source = search.source;
        if (vehicle) source.vehicle = vehicle->description, source.vehicleName = vehicle->stem, makeFolder(folder);
        source.folder = folder.string(), source.examplesFile = examples.string();
        source.labelsFile = labels.string(), source.learnedFile = learned.string();
        source.limits = detection::severityLimitsFromText(light, moderate);
        source.jobs = studies::coresHere();
        takeRecords(search, record);
        std::optional<detection::DetectionReport> report;
        computeAside(progress, [&](Monitor& monitor) { report = found(search, monitor); });
        return detectionOf(std::move(report).value());
      },
      py::arg("record"), py::kw_only(), py::arg("case") = py::none(), py::arg("folder") = ".", py::arg("examples") = "",
      py::arg("labels") = "", py::arg("learned") = "", py::arg("light") = "", py::arg("moderate") = "",
      py::arg("chainage") = py::none(), py::arg("wheel_diameter") = py::none(),
      py::arg("threshold") = detection::DetectOptions().threshold,
      py::arg("false_alarms") = detection::DetectOptions().falseAlarms,
      py::arg("least_share") = detection::DetectOptions().leastShare, py::arg("axle") = py::none(),
      py::arg("consecutive") = false, py::arg("passes") = false, py::arg("threads") = 0,
      py::arg("progress") = py::none(), detectDoc);
}

}  // namespace squat::python
