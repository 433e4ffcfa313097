// app/commands/SlurmScripts.h - a study as an array of jobs of the Slurm batch system.
#pragma once

#include <string>
#include <vector>

namespace squat::commands {

struct SlurmJob {
  std::vector<std::string> call;   // the study's own words from the program's path on, without those about parts
  std::string folder;              // of the study
  std::string partition;           // with the task's number in place of M: "slice:%/16"
  std::vector<std::size_t> parts;  // to be computed
  std::string time;                // as Slurm reads it; empty: the cluster's default
  int cores = 1;                   // of each task
  bool repeatsFailed = false;
};

// A word of a shell's line.
std::string quoted(const std::string& word);

// "1-4,7,9-16"
std::string arrayText(const std::vector<std::size_t>& parts);

// The array computes the parts, the other script puts them together.
std::string arrayScript(const SlurmJob& job);
std::string collectScript(const SlurmJob& job);

// Writes FOLDER/study.slurm and FOLDER/study-collect.slurm; the paths. FileError.
std::vector<std::string> writeScripts(const SlurmJob& job);

// Hands both to sbatch, the second to start when the first has ended, however it ended. Returns a line that says so;
// RunError with sbatch's own words where it refuses.
std::string submitScripts(const std::vector<std::string>& scripts);

}  // namespace squat::commands
