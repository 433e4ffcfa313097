// python/Events.h - what a search has found, as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "detection/DetectionFiles.h"

namespace squat::python {

// One event of a report, which it keeps alive.
struct Event {
  std::shared_ptr<const detection::DetectionReport> report;
  std::size_t index = 0;

  const detection::CombinedEvent& combined() const { return report->events[index]; }
  const detection::Event& event() const { return combined().event; }
};

struct Detection {
  std::shared_ptr<const detection::DetectionReport> report;
  pybind11::list events;  // of Event
};

Detection detectionOf(detection::DetectionReport report);
void addEvents(pybind11::module_& module);

}  // namespace squat::python
