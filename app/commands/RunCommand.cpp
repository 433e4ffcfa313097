#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/DrivenRun.h"
#include "commands/ExitCodes.h"
#include "commands/FigureNames.h"
#include "commands/FigureOutput.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/OutputFolder.h"
#include "commands/PaperTable.h"
#include "commands/RunFiles.h"
#include "commands/RunReport.h"
#include "commands/TerminalMonitor.h"
#include "commands/TimingsTable.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "core/platform/Memory.h"
#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "simulation/WarmStateFile.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

using text::roundedText;

struct RunCommandOptions {
  CaseOptions caseOptions;
  DrivenOptions driven;
  std::string folder = ".";
  std::string warmFile;
  simulation::RunOptions run;
  NamedFigures figures;
  bool noFigures = false, verbose = false, timings = false, json = false;
};

// --resume: true where the finished result of this very case stands already. Throws where it is another case's.
bool alreadyDone(const RunFiles& files, const std::string& hash) {
  std::error_code ignored;
  const auto otherCase = [&](const std::string& path, const std::string& found) {
    throw CaseError({{"--resume", path + " (case " + found + ")", "the same case (" + hash + ")",
                      "It belongs to another case: leave out --resume, or choose another folder with -o"}});
  };
  if (const auto state = results::readCheckpoint(files.checkpoint())) {
    const auto found = results::textAttribute(state->attributes, "case_hash", hash);
    if (found != hash) otherCase(files.checkpoint(), found);
    return false;
  }
  if (!std::filesystem::exists(files.result(), ignored)) return false;
  const auto result = results::readResult(files.result());
  if (!result.complete) return false;
  if (result.caseHash != hash) otherCase(files.result(), result.caseHash);
  return true;
}

std::vector<std::string> drawFigures(const RunCommandOptions& options, const results::RunResult& result) {
  if (options.noFigures || !result.complete) return {};
  if (!figuresAvailable()) {
    std::fprintf(stderr,
                 "No figures in the headless build. Draw them with squat render in the full build (package "
                 "squat-studio, or cmake --preset release).\n");
    return {};
  }
  const auto output = writeFigures(result, options.folder, options.figures);
  for (const auto& message : output.messages) std::fprintf(stderr, "%s\n", message.c_str());
  return output.files;
}

void printWritten(const std::vector<std::string>& paths) {
  std::printf("\nwritten:\n");
  for (const auto& path : paths) std::printf("  %s\n", path.c_str());
}

void printReport(const results::RunResult& result, const std::vector<std::string>& paths) {
  std::fputs(runReport(result, paths).c_str(), stdout);
}

// What a failed run has so far is kept; then the failure goes on to whoever reports it.
void keepPart(const RunFiles& files, const results::RunResult& partial) {
  if (partial.time.empty()) return;
  try {
    for (const auto& path : writeRunFiles(files, partial)) std::fprintf(stderr, "partial file: %s\n", path.c_str());
  } catch (const FileError& error) {
    std::fprintf(stderr, "cannot save the partial signals: %s\n", error.what());
  }
}

void printTables(const RunCommandOptions& options, const results::RunResult& result) {
  if (options.json) return;
  if (options.verbose) std::printf("%s\n", modesTable(result).c_str());
  if (options.verbose || options.timings) std::printf("%s\n", phasesTable(result).c_str());
  std::vector<std::string> setByHand;
  for (const auto& [key, value] : caseOverrides(options.caseOptions).values) setByHand.push_back(key);
  std::printf("%s", paperTable(result, setByHand).c_str());
  std::fflush(stdout);
}

// Files first: a reader of the output that has gone ends the program. Numbers are seen even where no file can be
// written.
std::vector<std::string> writeAndPrint(const RunCommandOptions& options, const RunFiles& files,
                                       const results::RunResult& result) {
  std::vector<std::string> written;
  try {
    written = writeRunFiles(files, result);
  } catch (const FileError&) {
    if (const auto path = writeSignalsAlone(files, result))
      std::fprintf(stderr, "saved the signals only: %s\n", path->c_str());
    printTables(options, result);
    throw;
  }
  printTables(options, result);
  for (auto& path : drawFigures(options, result)) written.push_back(std::move(path));
  return written;
}

// A run that was cancelled ahead of its first sample has nothing to keep, and replaces nothing.
bool hasNothing(const RunFiles& files, const results::RunResult& result) {
  std::error_code ignored;
  return result.time.empty() && (!canResume(files) || std::filesystem::exists(files.result(), ignored));
}

int reportCancelled(const RunFiles& files, const char* what) {
  std::fprintf(stderr, "cancelled: %s; %s\n", what,
               canResume(files) ? "squat run --resume continues this run" : "no checkpoint to resume from");
  return kCancelled;
}

// Of the whole command: drawing takes more than the simulation of a small mesh.
void printMemory() {
  constexpr double mebibyte = 1 << 20;
  std::printf("\npeak memory of the command: %s\n",
              roundedText(std::round(platform::peakMemory() / mebibyte), "MiB").c_str());
}

// --warm: the case on the mesh of the warm state, which `run` is to start from. Throws where it does not fit.
cases::CaseDescription onMeshOfWarmState(const std::string& file, const cases::CaseDescription& description,
                                         simulation::RunOptions& run) {
  auto warm = simulation::readWarmState(file);
  simulation::requireFit(warm, description);
  auto meshed = simulation::onMeshOf(warm, description);
  if (cases::caseHash(meshed) != cases::caseHash(description))
    std::fprintf(stderr, "mesh as in %s: mesh.zone_before = %s mm, mesh.zone_behind = %s mm\n", file.c_str(),
                 cases::valueText(meshed, *cases::findParameter("mesh.zone_before")).c_str(),
                 cases::valueText(meshed, *cases::findParameter("mesh.zone_behind")).c_str());
  run.warm = std::make_shared<const simulation::WarmState>(std::move(warm));
  return meshed;
}

int runOneCase(const RunCommandOptions& options) {
  if (options.driven.isAsked()) return driveRun(options.driven, options.caseOptions, options.run);
  auto runOptions = options.run;
  auto description = readCase(options.caseOptions);
  if (!options.warmFile.empty()) description = onMeshOfWarmState(options.warmFile, description, runOptions);
  const RunFiles files{options.folder, stemOf(options.caseOptions)};
  keepInputsOfRun(files, options.caseOptions.name, description);
  if (!options.noFigures) checkFigureNames(options.figures, &description);
  const OutputFolder folder(options.folder);
  prepareFolder(files);
  const FolderLock owner(options.folder, "squat run " + options.caseOptions.name);
  const auto hash = cases::caseHash(description);
  if (options.run.resume && alreadyDone(files, hash)) {
    if (options.json)
      printReport(results::readResult(files.result()), {files.result(), files.signals()});
    else
      std::printf("%s is already complete\n", files.result().c_str());
    return kDone;
  }
  if (!options.run.resume)
    for (const auto& line : keepOtherCases(files, hash)) std::fprintf(stderr, "%s\n", line.c_str());

  runOptions.checkpointPath = files.checkpoint();
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  std::string timings;
  if (options.timings) runOptions.timed = [&](const dynamics::StepTimings& steps) { timings = timingsTable(steps); };
  results::RunResult result, partial;
  try {
    result = simulation::runCase(description, runOptions, monitor, &partial);
  } catch (const RunError&) {
    monitor.clearLine();
    partial.stem = files.stem;
    partial.complete = false;
    keepPart(files, partial);
    throw;
  }
  monitor.clearLine();
  result.stem = files.stem;
  if (!result.complete && hasNothing(files, result)) return reportCancelled(files, "nothing recorded, no file written");
  const auto begun = std::chrono::steady_clock::now();
  const auto written = writeAndPrint(options, files, result);
  if (options.timings)
    std::printf(
        "\n%s\nfiles and figures: %s\n", timings.c_str(),
        roundedText(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), "s").c_str());
  if (options.json) {
    printReport(result, written);
  } else {
    printWritten(written);
    printMemory();
  }
  return result.complete ? kDone : reportCancelled(files, "the result is marked incomplete");
}

}  // namespace

void addRunCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("run", "Run a case; write result file, signals and figures; print a table");
  auto options = std::make_shared<RunCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions);
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addThreads(*command, options->run.threads);
  addInstructionSet(*command, options->run.isa);
  command->add_flag("--resume", options->run.resume, "Resume from the checkpoint, if there is one");
  command->add_option("--warm", options->warmFile, "Start just before the defect, from a file of squat warm")
      ->type_name("FILE");
  command
      ->add_option("--checkpoint-every", options->run.checkpointSeconds, "Seconds between checkpoints (default: 300)")
      ->check(between(0.0, 1e6))
      ->type_name("SECONDS");
  addFigureNames(*command, options->figures);
  command->add_flag("--no-figures", options->noFigures, "Draw no figures")->excludes("--figures");
  addDrivenOptions(*command, options->driven);
  command->add_flag("--json", options->json, "Print one JSON object instead of the tables: features, energies, files");
  command->add_flag("--verbose", options->verbose,
                    "Also print the natural modes of the half wheelset and the time of each phase");
  command
      ->add_flag("--timings", options->timings,
                 "Also print the time of each phase of the run, and of a step by phase and thread")
      ->excludes("--json")
      ->excludes("--parameters");
  command->callback([options, &action] { action = [options] { return runOneCase(*options); }; });
}

}  // namespace squat::commands
