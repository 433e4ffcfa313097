// solver/simulation/Signals.h - the output signals of a run, one row each.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/Rolling.h"

namespace squat::simulation {

// Value of a signal in the step just made; called once for every step.
using Probe = std::function<double(const dynamics::Rolling&)>;

struct Signal {
  const char* name;
  const char* unit;
  const char* description;
  Probe probe;
  const char* filteredName = nullptr;  // also stored low-passed at output.filter_cutoff under this name
};

// To add a signal, add its row. The last row is the position, the axis of all others. Throws CaseError where a sensor
// stands beside the track.
std::vector<Signal> outputSignals(const dynamics::Rolling& rolling);

}  // namespace squat::simulation
