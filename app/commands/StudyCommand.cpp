#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/StudySummary.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "studies/CaseStudy.h"
#include "studies/Jobs.h"
#include "studies/SharedStart.h"

namespace squat::commands {

namespace {

struct StudyCommandOptions {
  CaseOptions caseOptions;
  std::vector<std::string> variations;
  studies::StudyOptions study;
  simulation::RunOptions run;
  FigureChoice figures;
  int jobs = 0;
  bool keepResults = false, resume = false;
};

constexpr double kBytesOfARun = 2.0 * (1ULL << 30);  // the paper's mesh takes 1.5 GiB

// Several small runs at once use the cores better than the threads of one.
void shareCores(StudyCommandOptions& options) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.study.jobs =
      options.jobs > 0 ? options.jobs : studies::jobsThatFit(std::max(1, options.run.threads), kBytesOfARun);
  if (options.run.threads == 0) options.run.threads = std::max(1, cores / options.study.jobs);
}

int study(StudyCommandOptions options) {
  const auto overrides = caseOverrides(options.caseOptions);
  const auto definition = studies::studyOf(options.caseOptions.name, overrides, options.variations);
  shareCores(options);
  options.run.wheelsetModes = false;
  options.run.snapshots = false;
  if (options.study.folder.empty()) options.study.folder = ".";
  makeFolder(options.study.folder);
  const FolderLock owner(options.study.folder, "squat study " + options.caseOptions.name);

  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  const int cores = options.run.threads * options.study.jobs;
  studies::SharedStart start(definition, overrides, options.run, cores);
  const auto run = [&](const cases::CaseDescription& description, const studies::StudyPoint& point, Monitor& own) {
    auto result = start.run(description, own);
    char name[32];
    std::snprintf(name, sizeof name, "run-%04zu", point.index + 1);
    result.stem = name;
    if (options.keepResults && result.complete) results::writeResult(options.study.folder + "/" + name + ".h5", result);
    return result;
  };
  const auto table = studies::runCaseStudy(definition, overrides, run, options.study, monitor);
  monitor.clearLine();
  std::printf("%s\n", studySummary(table).c_str());
  std::printf("%s/study.csv: %zu of %zu runs done\n", options.study.folder.c_str(),
              table.count(studies::RowState::done), table.rows.size());
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::failed)
      std::fprintf(stderr, "failed: %s: %s\n", studies::toText(definition, row.point).c_str(), row.message.c_str());
  if (InterruptGuard::asked()) {
    std::fprintf(stderr, "cancelled: repeat the command to resume\n");
    return kCancelled;
  }
  for (const auto& path : writeStudyFigures(table, options.study.folder, options.figures))
    std::printf("%s\n", path.c_str());
  return table.count(studies::RowState::failed) > 0 ? kRunFailed : kDone;
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("study", "Run a case for all combinations of the given values; one table of features");
  auto options = std::make_shared<StudyCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  command->add_option("--vary", options->variations, "Values of one key: KEY=FROM:TO:COUNT or KEY=V,W,...; repeatable")
      ->required()
      ->allow_extra_args(false)
      ->type_name("KEY=...");
  command->add_option("-o,--output", options->study.folder, "Folder of the table and figures (default: here)")
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: as many as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  addThreads(*command, options->run.threads, "Threads of each run (default: cores / jobs)");
  addInstructionSet(*command, options->run.isa);
  addFigureOptions(*command, options->figures);
  command->add_flag("--keep-results", options->keepResults, "Keep the result file of each run");
  command->add_flag("--retry-failed", options->study.retryFailed, "Repeat failed runs");
  command->add_flag("--resume", options->resume, "Resume an interrupted study in this folder (the default)");
  command->callback([options, &action] { action = [options] { return study(*options); }; });
}

}  // namespace squat::commands
