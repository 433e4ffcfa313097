// solver/detection/MakeExamples.h - examples computed by the solver for one vehicle on one track.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "core/Monitor.h"
#include "detection/Examples.h"
#include "results/RunResult.h"
#include "simulation/RunCase.h"

namespace squat::detection {

struct ExampleOptions {
  std::size_t squats = 45, others = 16, flats = 4;  // passages
  std::uint32_t seed = 1;
  int jobs = 1;          // runs at once, each on one thread
  std::string isa;       // instruction set; empty: the best
  std::string passages;  // folder for the signals; empty: not kept
};

// Rolls the case's wheel over exampleSquats() and exampleOthers(), each group from one warm state where its members
// share the track, and one with exampleFlats() over smooth rail. The case's own defect and tread do not count. Runs
// that fail are left out; nothing where it was cancelled. Signals are written as PASSAGES/KIND-NNN.csv: time [s],
// position [m] from the deepest point, aba [m/s2]; a comment ahead says over what. Throws CaseError for a case that
// cannot be run, RunError where no run came to its end.
std::optional<std::vector<Example>> makeExamples(const cases::CaseDescription& description,
                                                 const ExampleOptions& options, Monitor& monitor);

// The example that a complete result is. Throws SignalError.
Example exampleOf(const results::RunResult& result, Kind kind, double length, double depth);

}  // namespace squat::detection
