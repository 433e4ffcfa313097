#include <cstdio>
#include <optional>

#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/EstimateEach.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "estimation/EstimateFiles.h"
#include "estimation/EstimateSummary.h"
#include "studies/Jobs.h"

namespace squat::commands {

namespace {

struct EstimateCommandOptions {
  CaseOptions caseOptions;  // without --mesh: see `mesh`
  SignalOptions signal;
  std::string mesh = "tiny", folder = ".", partition;
  estimation::EstimateDefinition definition;
  estimation::EstimateOptions estimate;
  FigureChoice figures;
  double longest = 70;  // [mm]
  int jobs = 0, threads = 0;
  bool json = false, each = false, collect = false;
};

void shareCores(EstimateCommandOptions& options) {
  const auto sharing = studies::shareMachine(studies::thisMachine(), studies::demandOnMesh(options.mesh),
                                             {options.jobs, options.threads});
  options.estimate.jobs = sharing.jobs, options.estimate.threads = sharing.threads;
}

int estimate(EstimateCommandOptions options) {
  auto& definition = options.definition;
  options.caseOptions.mesh = options.mesh;
  const auto description = readCase(options.caseOptions);
  definition.caseName = options.caseOptions.name;
  definition.overrides = caseOverrides(options.caseOptions);
  definition.reading = fileOptions(options.signal);
  definition.longest = 1e-3 * options.longest;
  const auto outputs =
      options.each ? std::vector{estimation::estimatesFile(options.folder)} : estimation::estimateFiles(options.folder);
  auto inputs = cases::filesOfCase(options.caseOptions.name, description);
  inputs.insert(inputs.end(), definition.files.begin(), definition.files.end());
  keepInputs(inputs, outputs);
  shareCores(options);
  makeFolder(options.folder);
  std::optional<FolderLock> owner;  // parts are locked one by one
  if (options.partition.empty()) owner.emplace(options.folder, "squat estimate " + definition.files.front());

  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  if (options.each)
    return estimateEach(
        {definition, options.estimate, options.folder, options.partition, options.collect, options.figures}, monitor);
  const auto found = estimation::estimateProfile(definition, options.estimate, monitor);
  monitor.clearLine();
  if (!found.profile.empty()) {
    estimation::writeEstimate(found, options.folder);
    if (options.json) {
      std::printf("%s", estimation::estimateJson(found).c_str());
    } else {
      std::printf("%s%s\nwritten:\n", found.complete ? "" : "Not finished; the best so far:\n\n",
                  estimation::estimateSummary(found).c_str());
      for (const auto& path : outputs) std::printf("  %s\n", path.c_str());
    }
    for (const auto& path : writeEstimateFigure(found, options.folder, options.figures))
      if (!options.json) std::printf("  %s\n", path.c_str());
  }
  if (found.complete) return kDone;
  std::fprintf(stderr, "cancelled%s\n", found.profile.empty() ? ": no profile was found yet, no file written" : "");
  return kCancelled;
}

}  // namespace

void addEstimateCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("estimate", "Estimate the profile of a defect from measured passages over it");
  auto options = std::make_shared<EstimateCommandOptions>();
  command
      ->add_option("measured", options->definition.files,
                   "CSV, HDF5 or MATLAB files: one or several passages over one defect")
      ->required()
      ->type_name("MEASURED...");
  addCaseWithoutMesh(*command, options->caseOptions, "--case");
  addMesh(*command, options->mesh, "Mesh of the runs (default: tiny)");
  addSignalOptions(*command, options->signal);
  command
      ->add_option("--low-pass", options->definition.cutoff,
                   "Low-pass filter of measured and computed signals (default: 2000)")
      ->check(between(200.0, 5000.0))
      ->type_name("HZ");
  command->add_option("--longest", options->longest, "Longest dip to look for (default: 70)")
      ->check(between(20.0, 200.0))
      ->type_name("MM");
  command->add_option("--runs", options->estimate.runs, "Runs after which the search ends (default: 150)")
      ->check(CLI::Range(20, 10000))
      ->type_name("N");
  command->add_option("-o,--output", options->folder, "Folder of the results (default: current folder)")
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: as many as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  addThreads(*command, options->threads, "Threads of each run (default: cores / jobs)");
  addInstructionSet(*command, options->estimate.isa);
  addFigureOptions(*command, options->figures);
  auto* json = command->add_flag("--json", options->json, "Print the estimate as JSON");
  auto* each = command
                   ->add_flag("--each", options->each,
                              "Each file is a passage over a defect of its own: results in DIR/FILE, all of them in "
                              "DIR/estimates.csv")
                   ->excludes(json);
  auto* partition = command
                        ->add_option("--partition", options->partition,
                                     "With --each, estimate only the M-th of N parts of the files: slice (every N-th "
                                     "file) or hash (by their names)")
                        ->type_name("KIND:M/N")
                        ->needs(each);
  command->add_flag("--collect", options->collect, "With --each, estimate nothing: combine the estimates of all parts")
      ->needs(each)
      ->excludes(partition);
  command->callback([options, &action] { action = [options] { return estimate(*options); }; });
}

}  // namespace squat::commands
