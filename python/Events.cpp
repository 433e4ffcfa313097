#include "python/Events.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "python/Arrays.h"

namespace squat::python {

namespace py = pybind11;

namespace {

bool isSquat(const Event& self) { return self.event().kind == detection::Kind::squat; }

// Of squats alone; else None.
template <typename Value>
py::object ofSquat(const Event& self, const Value& value) {
  return isSquat(self) ? py::cast(value) : py::none();
}

py::object range(const Event& self, double low, double high) { return ofSquat(self, std::make_pair(low, high)); }

py::object severities(const Event& self) {
  if (!isSquat(self)) return py::none();
  py::dict all;
  const auto& probabilities = self.event().judgement.severities;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    all[detection::toText(static_cast<detection::Severity>(i)).c_str()] = probabilities[i];
  return all;
}

py::object side(const Event& self) {
  const auto& judged = self.event().side;
  return judged ? py::object(py::str(detection::toText(judged->side()))) : py::none();
}

py::object sideSureness(const Event& self) {
  const auto& judged = self.event().side;
  return judged ? py::object(py::float_(judged->sureness())) : py::none();
}

py::object coordinate(double degrees) { return std::isfinite(degrees) ? py::object(py::float_(degrees)) : py::none(); }

// Events are few, so that their times are made, not kept.
py::object passageTime(const Event& self) {
  const auto& passage = self.event().passage;
  const auto numpy = py::module_::import("numpy");
  return numpy.attr("arange")(passage.values.size()) * py::float_(passage.step) + py::float_(passage.start);
}

using EventClass = py::class_<Event>;

template <typename Get>
void addProperty(EventClass& type, const char* name, Get get, const char* doc) {
  type.def_property_readonly(name, get, doc);
}

void addPlace(EventClass& type) {
  addProperty(
      type, "position", [](const Event& self) { return self.event().position; },
      "Position of the cause as the record counts [m]; of several passes, their mean in the first one's chainage: "
      "float.");
  addProperty(
      type, "time", [](const Event& self) { return self.event().time; }, "Time in the record [s]: float.");
  addProperty(
      type, "latitude", [](const Event& self) { return coordinate(self.event().latitude); },
      "Latitude [deg]: float, or None where the record has none.");
  addProperty(
      type, "longitude", [](const Event& self) { return coordinate(self.event().longitude); },
      "Longitude [deg]: float, or None where the record has none.");
  addProperty(
      type, "record",
      [](const Event& self) { return self.report->records[self.combined().records.front()].layout.path; },
      "Record in which it was found: str.");
  addProperty(
      type, "channel", [](const Event& self) { return self.event().channel; }, "Channel in which it was found: str.");
  addProperty(
      type, "extent", [](const Event& self) { return self.event().extent; },
      "Length of a stretch of corrugation from its position [m]; of all else 0: float.");
  addProperty(
      type, "passes", [](const Event& self) { return self.event().passes; }, "Passes that have the event: int.");
  addProperty(
      type, "passes_there", [](const Event& self) { return self.event().passesThere; },
      "Passes over this position: int.");
}

void addJudgement(EventClass& type) {
  addProperty(
      type, "kind", [](const Event& self) { return detection::toText(self.event().kind); },
      "squat, joint, weld, corrugation, flat or other: str.");
  addProperty(
      type, "sureness", [](const Event& self) { return self.event().sureness; },
      "Probability of the kind, 0 to 1: float.");
  addProperty(
      type, "severity",
      [](const Event& self) { return ofSquat(self, detection::toText(self.event().judgement.severity)); },
      "light, moderate or severe: str; None for what is no squat, here and in the following.");
  addProperty(type, "severities", &severities,
              "Probability of each severity if it is a squat: a dict of name and number from 0 to 1, or None.");
  addProperty(
      type, "length", [](const Event& self) { return ofSquat(self, self.event().judgement.length); },
      "Length [m], the median: float or None.");
  addProperty(
      type, "length_range",
      [](const Event& self) {
        return range(self, self.event().judgement.lengthLow, self.event().judgement.lengthHigh);
      },
      "Length [m] with a probability of 90 %: a tuple of low and high, or None.");
  addProperty(
      type, "depth", [](const Event& self) { return ofSquat(self, self.event().judgement.depth); },
      "Depth [m], the median: float or None.");
  addProperty(
      type, "depth_range",
      [](const Event& self) { return range(self, self.event().judgement.depthLow, self.event().judgement.depthHigh); },
      "Depth [m] with a probability of 90 %: a tuple of low and high, or None.");
  addProperty(type, "side", &side,
              "Rail with the defect, or wheel with the flat, of a wheelset with two channels: \"left\", \"right\" or "
              "\"both\"; else None.");
  addProperty(type, "side_sureness", &sideSureness, "Probability of the side, 0 to 1: float or None.");
  addProperty(
      type, "reason", [](const Event& self) { return self.event().reason; },
      "What decided, where it was not the signal (\"as labelled\"): str.");
}

void addSignal(EventClass& type) {
  addProperty(
      type, "score", [](const Event& self) { return self.event().score; }, "Evidence against the background: float.");
  addProperty(
      type, "false_alarms", [](const Event& self) { return self.event().falseAlarms; },
      "How often the background alone makes as much [1/km]: float.");
  addProperty(
      type, "peak", [](const Event& self) { return self.event().peak; },
      "Largest absolute acceleration around, up to 2 kHz [m/s2]: float.");
  addProperty(
      type, "speed", [](const Event& self) { return self.event().features.speed; }, "Speed there [m/s]: float.");
  addProperty(
      type, "wavelength", [](const Event& self) { return self.event().features.wavelength; },
      "Speed by the mean frequency from 560 to 2000 Hz [m]: float.");
  addProperty(
      type, "passage",
      [](const py::object& self) { return view(self.cast<const Event&>().event().passage.values, self); },
      "The signal over the event [m/s2]: array (n), read-only, not copied.");
  addProperty(type, "passage_time", &passageTime, "Times of passage [s]: array (n).");
  type.def("__repr__", [](const Event& self) {
    const auto format = py::str("<squat.Event {} at {:.3f} m, {:.0f} %>");
    return format.format(detection::toText(self.event().kind), self.event().position, 100 * self.event().sureness);
  });
}

py::list faultsOf(const Detection& self) {
  py::list all;
  for (const auto& record : self.report->records)
    for (const auto& fault : record.faults) {
      py::dict one;
      one["record"] = record.layout.path, one["time"] = fault.time, one["position"] = fault.position;
      one["text"] = fault.text, one["advice"] = fault.advice;
      all.append(one);
    }
  return all;
}

std::vector<std::string> notesOf(const Detection& self) {
  auto all = self.report->notes;
  for (const auto& record : self.report->records) all.insert(all.end(), record.notes.begin(), record.notes.end());
  return all;
}

}  // namespace

Detection detectionOf(detection::DetectionReport report) {
  Detection found{std::make_shared<const detection::DetectionReport>(std::move(report)), py::list()};
  for (std::size_t i = 0; i < found.report->events.size(); ++i) found.events.append(Event{found.report, i});
  return found;
}

void addEvents(py::module_& module) {
  EventClass type(module, "Event", "A place of a record that is louder than around, and what it is taken for.");
  addPlace(type);
  addJudgement(type);
  addSignal(type);

  py::class_<Detection>(module, "Detection",
                        "What a search has found: a list of Event, in the order of their positions.")
      .def("__len__", [](const Detection& self) { return self.events.size(); })
      .def("__iter__", [](const Detection& self) { return py::iter(self.events); })
      .def("__getitem__",
           [](const Detection& self, const py::object& index) -> py::object { return self.events[index]; })
      .def_property_readonly("faults", &faultsOf,
                             "What is wrong in the records: a list of dicts with record, time [s], position [m], text, "
                             "advice.")
      .def_property_readonly("notes", &notesOf, "What was assumed or is to be known: a list of str.")
      .def_property_readonly(
          "examples", [](const Detection& self) { return self.report->examples; },
          "What kinds and severities were judged by: str.")
      .def(
          "save",
          [](const Detection& self, const std::filesystem::path& folder) {
            const auto report = self.report;
            const py::gil_scoped_release others;
            return detection::writeDetection(*report, folder.string());
          },
          py::arg("folder"),
          R"(Write squats.csv, squats.json, squats.geojson where there are coordinates, and the signal over each
squat in passages. Returns the paths. Raises FileError.)");
}

}  // namespace squat::python
