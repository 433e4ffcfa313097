// solver/simulation/WarmStateFile.h - a warm state on disk, STEM.warm.
#pragma once

#include <string>

#include "simulation/WarmState.h"

namespace squat::simulation {

// Replaces what stands under `path` whole or not at all. FileError where it cannot be written.
void writeWarmState(const std::string& path, const WarmState& warm);

// Throws FileError for a file that is missing, damaged or no warm state, and for one of another version of the program,
// whose equilibrium and run-up may differ.
WarmState readWarmState(const std::string& path);

}  // namespace squat::simulation
