// solver/simulation/Signals.h - the output signals of a run, with what probes them.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/Rolling.h"
#include "signals/SignalCatalogue.h"

namespace squat::simulation {

// Value of a signal in the step just made; called once for every step.
using Probe = std::function<double(const dynamics::Rolling&)>;

struct Signal : signals::CatalogueRow {
  Probe probe;
};

// Those of the catalogue, each with its probe; the irregularity of a rail that has one. The last is the position, the
// axis of all others. Throws CaseError where a sensor stands beside the track.
std::vector<Signal> outputSignals(const dynamics::Rolling& rolling);

}  // namespace squat::simulation
