// app/commands/DrivenRun.h - squat run --parameters --results: one run for another program's loop.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands/CaseOptions.h"
#include "simulation/RunCase.h"

namespace squat::commands {

struct DrivenOptions {
  std::string parameters, results;
  std::vector<std::string> features;

  bool isAsked() const { return !parameters.empty(); }
};

void addDrivenOptions(CLI::App& command, DrivenOptions& options);

// The case with the values of the parameters file; the features go into the results file, and nothing else is written.
// Whatever goes wrong, the results file says so, and the error goes on to whoever reports it.
int driveRun(const DrivenOptions& driven, const CaseOptions& caseOptions, simulation::RunOptions run);

}  // namespace squat::commands
