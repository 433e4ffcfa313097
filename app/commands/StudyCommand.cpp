#include <cstdio>
#include <optional>
#include <utility>

#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/StudyOnCluster.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "core/platform/Terminal.h"
#include "studies/CaseStudy.h"
#include "studies/CollectParts.h"
#include "studies/ComputeStudy.h"
#include "studies/StudySummary.h"

namespace squat::commands {

namespace {

struct StudyCommandOptions {
  CaseOptions caseOptions;
  studies::StudyRequest request;
  studies::StudyJob job;  // without its definition
  FigureChoice figures;
  ClusterOptions cluster;
  std::string partition;
  int jobs = 0, threads = 0;
  bool resume = false, collect = false, yes = false;
};

int printSummary(const studies::StudyTable& table, const std::string& path) {
  std::printf("%s\n", studies::studySummary(table).c_str());
  std::printf("%s: %zu of %zu runs done\n", path.c_str(), table.count(studies::RowState::done), table.rows.size());
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::failed)
      std::fprintf(stderr, "failed: %s: %s\n", studies::toText(table.definition, row.point).c_str(),
                   row.message.c_str());
  return table.count(studies::RowState::failed) > 0 ? kRunFailed : kDone;
}

void drawStudyFigures(const StudyCommandOptions& options, const studies::StudyTable& table) {
  for (const auto& path : writeStudyFigures(table, options.job.study.folder, options.figures))
    std::printf("%s\n", path.c_str());
}

int collectParts(const StudyCommandOptions& options) {
  const auto& folder = options.job.study.folder;
  const FolderLock owner(folder, "squat study --collect");
  const auto table = studies::writeCollected(options.job.definition, folder);
  const int code = printSummary(table, studies::studyFiles(folder).front());
  drawStudyFigures(options, table);
  return code;
}

void printCost(const studies::StudyCost& cost) {
  std::fprintf(stderr, "estimate: %s\n", studies::toText(cost).c_str());
}

// False where it takes above an hour on so many cores and whoever sits at the terminal says no.
bool isWanted(const StudyCommandOptions& options, double coreHours) {
  const int cores = options.job.run.threads * options.job.study.jobs;
  if (coreHours < cores || options.yes || !platform::isTerminal(stdin) || !platform::isTerminal(stderr)) return true;
  std::fprintf(stderr, "%.2g hours on %d cores. Start? [y/N] ", coreHours / cores, cores);
  const int answer = std::getchar();
  return answer == 'y' || answer == 'Y';
}

int compute(StudyCommandOptions options) {
  auto& job = options.job;
  const auto cost = studies::costAhead(job);
  if (cost.runs > 0) printCost(cost);
  studies::shareCores(job, options.jobs, options.threads, cost);
  if (!isWanted(options, cost.coreHours())) {
    std::fprintf(stderr, "not started\n");
    return kCancelled;
  }
  makeFolder(job.study.folder);
  std::optional<FolderLock> owner;  // parts are locked one by one
  if (!job.study.part) owner.emplace(job.study.folder, "squat study " + options.caseOptions.name);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  const auto table = studies::computeStudy(job, monitor);
  monitor.clearLine();
  const int code = printSummary(table, studies::studyFiles(job.study.folder, job.study.part).front());
  if (InterruptGuard::asked()) {
    std::fprintf(stderr, "cancelled: repeat the command to resume\n");
    return kCancelled;
  }
  if (!job.study.part) drawStudyFigures(options, table);
  return code;
}

// The study as a call without what concerns its parts.
std::vector<std::string> commandWords(const StudyCommandOptions& options) {
  std::vector<std::string> words{options.caseOptions.name};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {name, value});
  };
  add("--mesh", options.caseOptions.mesh);
  for (const auto& set : options.caseOptions.sets) add("--set", set);
  for (const auto& variation : options.request.variations) add("--vary", variation);
  add("--sample", options.request.sample);
  if (!options.request.sample.empty()) add("--seed", std::to_string(options.request.seed));
  add("--points", options.request.pointsFile);
  add("-o", options.job.study.folder);
  add("--name", options.caseOptions.stem);
  add("--isa", options.job.run.isa);
  if (options.jobs > 0) add("--jobs", std::to_string(options.jobs));
  if (options.threads > 0) add("--threads", std::to_string(options.threads));
  if (options.job.keepResults) words.emplace_back("--keep-results");
  if (options.figures.none) words.emplace_back("--no-figures");
  for (const auto& format : options.figures.formats) add("--format", format);
  return words;
}

int study(StudyCommandOptions options) {
  auto& job = options.job;
  if (!options.partition.empty()) job.study.part = studies::partitionFromText(options.partition);
  if (job.study.folder.empty()) job.study.folder = ".";
  if (!options.caseOptions.stem.empty()) job.stem = options.caseOptions.stem;
  job.overrides = caseOverrides(options.caseOptions);
  job.definition = studies::studyOf(options.caseOptions.name, job.overrides, options.request);
  if (options.cluster.parts > 0)
    printCost({studies::costOfARun(job.definition, job.overrides), studies::gridOf(job.definition).size()});
  if (options.cluster.isAsked())
    return prepareForCluster(options.cluster, job.definition, job.study.folder, commandWords(options));
  if (options.cluster.submit) throw CaseError({{"--submit", "given alone", "given with --slurm N or --resubmit", ""}});
  return options.collect ? collectParts(options) : compute(std::move(options));
}

void addPoints(CLI::App& command, studies::StudyRequest& request) {
  auto* vary = command
                   .add_option("--vary", request.variations,
                               "Values of one key: KEY=FROM:TO:COUNT or KEY=V,W,...; with --sample its limits, "
                               "KEY=LOW:HIGH; repeatable")
                   ->allow_extra_args(false)
                   ->type_name("KEY=...");
  auto* sample = command
                     .add_option("--sample", request.sample,
                                 "N points between the limits in place of all combinations: sobol:N (best with 64, "
                                 "128, 256, ...) or latin-hypercube:N")
                     ->type_name("METHOD:N")
                     ->needs(vary);
  command.add_option("--seed", request.seed, "Which of the samples (default: 1)")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53))
      ->type_name("N")
      ->needs(sample);
  command
      .add_option("--points", request.pointsFile,
                  "Points from a file (CSV): keys in its first line, a point in each other one")
      ->type_name("FILE")
      ->excludes(vary)
      ->excludes(sample);
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("study", "Run a case for all combinations of the given values; one table of features");
  auto options = std::make_shared<StudyCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions, "Name of the results of --keep-results, before their numbers (default: run)");
  addPoints(*command, options->request);
  command
      ->add_option("-o,--output", options->job.study.folder,
                   "Folder of the table and figures (default: current folder)")
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: as many as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  addThreads(*command, options->threads, "Threads of each run (default: cores / jobs)");
  addInstructionSet(*command, options->job.run.isa);
  addFigureOptions(*command, options->figures);
  command->add_flag("--keep-results", options->job.keepResults, "Keep the result file of each run");
  command->add_flag("--retry-failed", options->job.study.retryFailed, "Repeat failed runs");
  auto* partition =
      command
          ->add_option("--partition", options->partition,
                       "Compute the M-th of N parts only, into a table of its own: slice (every N-th point) or hash "
                       "(points keep their part when others are added)")
          ->type_name("KIND:M/N");
  auto* collecting =
      command->add_flag("--collect", options->collect, "Compute nothing: put the tables of all parts together")
          ->excludes(partition);
  addClusterOptions(*command, options->cluster, {partition, collecting});
  command->add_flag("--yes", options->yes, "Start without asking, however long it takes");
  command->add_flag("--resume", options->resume, "Resume an interrupted study in this folder (the default)");
  command->callback([options, &action] { action = [options] { return study(*options); }; });
}

}  // namespace squat::commands
