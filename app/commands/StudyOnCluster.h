// app/commands/StudyOnCluster.h - squat study --slurm and --resubmit: scripts in place of runs.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "studies/StudyGrid.h"

namespace squat::commands {

struct ClusterOptions {
  int parts = 0;  // --slurm
  bool resubmit = false, submit = false;
  std::string time;
  int cores = 1;

  bool isAsked() const { return parts > 0 || resubmit; }
};

// --slurm, --resubmit, --submit, --time and --cores; `others` are options that do not go with the first two.
void addClusterOptions(CLI::App& command, ClusterOptions& options, const std::vector<CLI::Option*>& others);

// Writes the scripts for all parts, or for those of a study in `folder` that are not complete, and submits them where
// asked to. `call` holds the study's own words. Exit code.
int prepareForCluster(const ClusterOptions& options, const studies::StudyDefinition& definition,
                      const std::string& folder, std::vector<std::string> call);

}  // namespace squat::commands
