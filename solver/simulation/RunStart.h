// solver/simulation/RunStart.h - how a run was begun: found ahead of the rolling, kept in its checkpoints, so that
// nothing of it is done twice and the steps stay the same on another instruction set.
#pragma once

#include <string>

#include "results/ArrayTree.h"
#include "results/RunResult.h"

namespace squat::simulation {

constexpr double maximumStepsPerSample = 1e5;  // the filter before the samples keeps some twenty samples of them

struct RunStart {
  long stepsPerSample = 0;
  double step = 0, beta = 0;  // [s]
};

// A state to resume from: a checkpoint, or a warm state. May be an untrusted file.
struct StoredState {
  const results::ArrayTree& tree;
  std::string file;     // for messages
  std::string instead;  // what to do where it does not fit: "start the run again without --resume"
};

// With the figures of mesh, equilibrium and modes. Loading throws FileError where they are missing or damaged, do not
// fit the output rate [Hz], or the file keeps its state in the order of another version.
void saveStart(const RunStart& start, const results::RunResult& result, results::ArrayTree& tree);
RunStart loadStart(const StoredState& stored, double rate, results::RunResult& result);

}  // namespace squat::simulation
