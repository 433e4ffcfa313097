#include "commands/StudyOnCluster.h"

#include <cstdio>
#include <filesystem>

#include "commands/ExitCodes.h"
#include "commands/SlurmScripts.h"
#include "core/Errors.h"
#include "core/platform/ProgramPath.h"
#include "studies/CollectParts.h"

namespace squat::commands {

namespace {

std::string thisProgram() {
  const auto path = platform::programPath();
  return path.empty() ? std::string("squat") : path.string();
}

// The parts that miss points or hold failed ones.
void takeIncomplete(const studies::CollectedStudy& study, SlurmJob& job) {
  std::size_t failed = 0;
  for (const auto& part : study.parts) {
    if (!part.isComplete() || part.failed > 0) job.parts.push_back(part.part.part);
    failed += part.failed;
  }
  job.repeatsFailed = failed > 0;
  std::printf("%zu of %zu parts: %zu points missing, %zu failed\n", job.parts.size(), study.parts.size(),
              study.missing(), failed);
}

std::string withPlaceForTask(const studies::Partition& family) {
  const auto text = studies::familyOf(family);
  const auto colon = text.find(':');
  return text.substr(0, colon + 1) + "%/" + text.substr(colon + 1);
}

}  // namespace

void addClusterOptions(CLI::App& command, ClusterOptions& options, const std::vector<CLI::Option*>& others) {
  auto* slurm = command
                    .add_option("--slurm", options.parts,
                                "Compute nothing: write the scripts of N parts as an array of Slurm jobs, and of the "
                                "job that collects them")
                    ->check(CLI::Range(1, static_cast<int>(studies::kMaximumParts)))
                    ->type_name("N");
  auto* resubmit = command.add_flag("--resubmit", options.resubmit,
                                    "The same for those parts of the study in the folder that miss points or failed");
  resubmit->excludes(slurm);
  for (auto* other : others) {
    slurm->excludes(other);
    resubmit->excludes(other);
  }
  command.add_flag("--submit", options.submit, "Submit the scripts as well");
  command
      .add_option("--time", options.time, "Time limit of a part, as Slurm reads it: 2:00:00 (default: the cluster's)")
      ->type_name("TIME");
  command.add_option("--cores", options.cores, "Cores of each part (default: 1)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

int prepareForCluster(const ClusterOptions& options, const studies::StudyDefinition& definition,
                      const std::string& folder, std::vector<std::string> call) {
  call.insert(call.begin(), {thisProgram(), "study"});
  SlurmJob job{std::move(call), folder, "", {}, options.time, options.cores, false};
  if (options.resubmit) {
    const auto study = studies::collectParts(definition, folder);
    takeIncomplete(study, job);
    if (job.parts.empty()) return kDone;
    job.partition = withPlaceForTask(study.parts.front().part);
  } else {
    for (int part = 1; part <= options.parts; ++part) job.parts.push_back(static_cast<std::size_t>(part));
    job.partition = "slice:%/" + std::to_string(options.parts);
  }
  const auto scripts = writeScripts(job);
  for (const auto& path : scripts) std::printf("%s\n", path.c_str());
  if (options.submit)
    std::printf("%s\n", submitScripts(scripts).c_str());
  else
    std::printf("submit: job=$(sbatch --parsable %s) && sbatch --dependency=afterany:$job %s\n",
                quoted(scripts[0]).c_str(), quoted(scripts[1]).c_str());
  return kDone;
}

}  // namespace squat::commands
