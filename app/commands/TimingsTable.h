// app/commands/TimingsTable.h - where the time of a step goes, for `squat run --timings`.
#pragma once

#include <string>

#include "dynamics/StepTimings.h"

namespace squat::commands {

// Microseconds a step of each phase and thread, and what all threads spend in it, as a share of their time. Phases
// that take no time are left out; empty where no step was timed.
std::string timingsTable(const dynamics::StepTimings& timings);

}  // namespace squat::commands
