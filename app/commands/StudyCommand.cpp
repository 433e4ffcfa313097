#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "case/ShortHash.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/StudyOnCluster.h"
#include "commands/StudySummary.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "studies/CaseStudy.h"
#include "studies/CollectParts.h"
#include "studies/CostEstimate.h"
#include "studies/Jobs.h"
#include "studies/SharedStart.h"

namespace squat::commands {

namespace {

struct StudyCommandOptions {
  CaseOptions caseOptions;
  studies::StudyRequest request;
  studies::StudyOptions study;
  simulation::RunOptions run;
  FigureChoice figures;
  ClusterOptions cluster;
  std::string partition;
  int jobs = 0;
  bool keepResults = false, resume = false, collect = false, yes = false;
};

constexpr double kBytesOfARun = 1ULL << 30;  // of a part; the paper's mesh takes a quarter of it

void shareCores(StudyCommandOptions& options, const studies::CostEstimate& cost) {
  const studies::RunDemand demand{cost.bytes, studies::kTrafficOfAThread,
                                  studies::kStateOfAnElement * static_cast<double>(cost.elements)};
  const auto sharing = studies::shareMachine(studies::thisMachine(), demand, {options.jobs, options.run.threads});
  options.study.jobs = sharing.jobs, options.run.threads = sharing.threads;
}

int report(const studies::StudyTable& table, const std::string& path) {
  std::printf("%s\n", studySummary(table).c_str());
  std::printf("%s: %zu of %zu runs done\n", path.c_str(), table.count(studies::RowState::done), table.rows.size());
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::failed)
      std::fprintf(stderr, "failed: %s: %s\n", studies::toText(table.definition, row.point).c_str(),
                   row.message.c_str());
  return table.count(studies::RowState::failed) > 0 ? kRunFailed : kDone;
}

void drawFigures(const StudyCommandOptions& options, const studies::StudyTable& table) {
  for (const auto& path : writeStudyFigures(table, options.study.folder, options.figures))
    std::printf("%s\n", path.c_str());
}

int collect(const StudyCommandOptions& options, const studies::StudyDefinition& definition) {
  const auto& folder = options.study.folder;
  const FolderLock owner(folder, "squat study --collect");
  const auto table = studies::writeCollected(definition, folder);
  const int code = report(table, studies::studyFiles(folder).front());
  drawFigures(options, table);
  return code;
}

// Of a point's files. Points that are added to a study change the numbers of others; parts by hash may grow.
std::string nameOf(const StudyCommandOptions& options, const studies::StudyDefinition& definition,
                   const studies::StudyPoint& point) {
  const std::string stem = (options.caseOptions.stem.empty() ? "run" : options.caseOptions.stem) + "-";
  if (options.study.part && options.study.part->kind == studies::Partition::Kind::hash)
    return stem + cases::shortHash(studies::toText(definition, point));
  char number[32];
  std::snprintf(number, sizeof number, "%04zu", point.index + 1);
  return stem + number;
}

double hoursOf(const studies::CostEstimate& cost, std::size_t runs) {
  return cost.coreSeconds * static_cast<double>(runs) / 3600;
}

void printEstimate(const studies::CostEstimate& cost, std::size_t runs) {
  std::fprintf(stderr, "estimate: %zu runs of %zu elements and %.0f steps, %.2g core hours; %.0f MiB a run\n", runs,
               cost.elements, cost.steps, hoursOf(cost, runs), cost.bytes / (1 << 20));
}

// False where it takes above an hour on so many cores and whoever sits at the terminal says no.
bool isWanted(const StudyCommandOptions& options, double coreHours) {
  const int cores = options.run.threads * options.study.jobs;
  if (coreHours < cores || options.yes || ::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) return true;
  std::fprintf(stderr, "%.2g hours on %d cores. Start? [y/N] ", coreHours / cores, cores);
  const int answer = std::getchar();
  return answer == 'y' || answer == 'Y';
}

std::size_t runsAhead(const StudyCommandOptions& options, const studies::StudyDefinition& definition) {
  auto table = studies::readTable(definition, options.study.folder);
  if (!table) table = studies::emptyTable(definition);
  return table->count(studies::RowState::open) +
         (options.study.retryFailed ? table->count(studies::RowState::failed) : 0);
}

int compute(StudyCommandOptions options, studies::StudyDefinition definition, const cases::CaseOverrides& overrides) {
  // A part leaves it to the call that made the scripts: it would cost more than the rest of its start.
  studies::CostEstimate cost;
  cost.bytes = kBytesOfARun;
  const auto runs = options.study.part ? 0 : runsAhead(options, definition);
  if (runs > 0) cost = studies::costOfARun(definition, overrides), printEstimate(cost, runs);
  shareCores(options, cost);
  if (!isWanted(options, hoursOf(cost, runs))) {
    std::fprintf(stderr, "not started\n");
    return kCancelled;
  }
  options.run.wheelsetModes = false;
  options.run.snapshots = false;
  const auto& folder = options.study.folder;
  makeFolder(folder);
  std::optional<FolderLock> owner;  // parts are locked one by one
  if (!options.study.part) owner.emplace(folder, "squat study " + options.caseOptions.name);

  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  const int cores = options.run.threads * options.study.jobs;
  studies::SharedStart start(definition, overrides, options.run, cores);
  definition.start = start.text();
  const auto run = [&](const cases::CaseDescription& description, const studies::StudyPoint& point, Monitor& own) {
    auto result = start.run(description, own);
    result.stem = nameOf(options, definition, point);
    if (options.keepResults && result.complete) results::writeResult(folder + "/" + result.stem + ".h5", result);
    return result;
  };
  const auto table = studies::runCaseStudy(definition, overrides, run, options.study, monitor);
  monitor.clearLine();
  const int code = report(table, studies::studyFiles(folder, options.study.part).front());
  if (InterruptGuard::asked()) {
    std::fprintf(stderr, "cancelled: repeat the command to resume\n");
    return kCancelled;
  }
  if (!options.study.part) drawFigures(options, table);
  return code;
}

// The study as a call without what concerns its parts.
std::vector<std::string> wordsOf(const StudyCommandOptions& options) {
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
  add("-o", options.study.folder);
  add("--name", options.caseOptions.stem);
  add("--isa", options.run.isa);
  if (options.jobs > 0) add("--jobs", std::to_string(options.jobs));
  if (options.run.threads > 0) add("--threads", std::to_string(options.run.threads));
  if (options.keepResults) words.emplace_back("--keep-results");
  if (options.figures.none) words.emplace_back("--no-figures");
  for (const auto& format : options.figures.formats) add("--format", format);
  return words;
}

int study(StudyCommandOptions options) {
  if (!options.partition.empty()) options.study.part = studies::partitionFromText(options.partition);
  if (options.study.folder.empty()) options.study.folder = ".";
  const auto overrides = caseOverrides(options.caseOptions);
  const auto definition = studies::studyOf(options.caseOptions.name, overrides, options.request);
  if (options.cluster.parts > 0)
    printEstimate(studies::costOfARun(definition, overrides), studies::gridOf(definition).size());
  if (options.cluster.isAsked())
    return prepareForCluster(options.cluster, definition, options.study.folder, wordsOf(options));
  if (options.cluster.submit) throw CaseError({{"--submit", "given alone", "given with --slurm N or --resubmit", ""}});
  return options.collect ? collect(options, definition) : compute(std::move(options), definition, overrides);
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
  command->add_option("-o,--output", options->study.folder, "Folder of the table and figures (default: current folder)")
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: as many as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  addThreads(*command, options->run.threads, "Threads of each run (default: cores / jobs)");
  addInstructionSet(*command, options->run.isa);
  addFigureOptions(*command, options->figures);
  command->add_flag("--keep-results", options->keepResults, "Keep the result file of each run");
  command->add_flag("--retry-failed", options->study.retryFailed, "Repeat failed runs");
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
