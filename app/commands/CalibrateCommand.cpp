#include <cstdio>

#include "calibration/Calibration.h"
#include "calibration/CalibrationFiles.h"
#include "calibration/CalibrationSummary.h"
#include "case/CaseDescription.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "studies/PartLock.h"

namespace squat::commands {

namespace {

struct CalibrateCommandOptions {
  CaseOptions caseOptions;  // without --mesh: see `mesh`
  std::vector<std::string> targets, free;
  std::string mesh = "tiny", confirm = "draft", partition;
  calibration::CalibrationOptions calibration;
  FigureChoice figures;
  int jobs = 0, threads = 0, evaluations = 0;
};

calibration::CalibrationDefinition calibrationOf(const CalibrateCommandOptions& options) {
  calibration::CalibrationDefinition definition;
  definition.caseName = options.caseOptions.name;
  definition.overrides = caseOverrides(options.caseOptions);
  definition.inputs = calibration::freeInputsFromText(options.free);
  definition.targets = calibration::readTargets(options.targets, options.caseOptions.name);
  definition.searchMesh = options.mesh, definition.confirmMesh = options.confirm;
  definition.evaluations = options.evaluations;
  return definition;
}

int calibratePart(const CalibrateCommandOptions& options, const calibration::CalibrationDefinition& definition,
                  Monitor& monitor) {
  const auto& part = *options.calibration.part;
  const studies::PartLock lock("calibrate", part, options.calibration.folder, studies::kPartBeat, monitor);
  const auto found = calibration::calibrate(definition, options.calibration, monitor);
  std::printf("%s: %zu points in %s\n", studies::toText(part).c_str(), found.evaluations.size(),
              calibration::partFolder(options.calibration.folder, part).c_str());
  if (found.complete) return kDone;
  std::fprintf(stderr, "cancelled: repeat the command to resume\n");
  return kCancelled;
}

int calibrate(CalibrateCommandOptions options) {
  if (!options.partition.empty()) options.calibration.part = studies::partitionFromText(options.partition);
  readCase(options.caseOptions);  // what is wrong with it is said before what is wrong with the targets
  const auto definition = calibrationOf(options);
  const auto& folder = options.calibration.folder;
  const auto stem = stemOf(options.caseOptions);
  calibration::keepInputsOf(definition, options.targets, folder, stem);
  calibration::shareCores(definition, options.jobs, options.threads, options.calibration);
  makeFolder(folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  if (options.calibration.part) return calibratePart(options, definition, monitor);

  const FolderLock owner(folder, "squat calibrate " + options.caseOptions.name);
  const auto found = calibration::calibrate(definition, options.calibration, monitor);
  monitor.clearLine();
  const auto summary = calibration::calibrationSummary(found);
  if (!found.complete && !summary.empty()) std::printf("Not finished; known so far:\n\n");
  std::printf("%s", summary.c_str());
  if (found.complete && !found.ranges.empty()) {
    const auto written = calibration::writeCalibrated(found, folder, stem);
    std::printf("\nwritten:\n");
    for (const auto& path : written) std::printf("  %s\n", path.c_str());
    for (const auto& path : writeCalibrationFigure(found, folder, options.figures)) std::printf("  %s\n", path.c_str());
  }
  if (!found.complete) {
    std::fprintf(stderr, "cancelled: repeat the command to resume\n");
    return kCancelled;
  }
  return found.outOfReach.empty() ? kDone : kFileWrong;
}

}  // namespace

void addCalibrateCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("calibrate", "Estimate unknown inputs of a case from what it has to reproduce");
  auto options = std::make_shared<CalibrateCommandOptions>();
  addCaseWithoutMesh(*command, options->caseOptions);
  addName(*command, options->caseOptions, "Name of the calibrated case (default: that of the case)");
  command
      ->add_option(
          "--targets", options->targets,
          "What the case has to reproduce: a target file (JSON), measured signals, a measured receptance, or one "
          "of the shipped: light-defect, paper; repeatable")
      ->required()
      ->allow_extra_args(false)
      ->type_name("FILE");
  command
      ->add_option("--free", options->free,
                   "An input to be found and its limits, in the unit of the case file; repeatable")
      ->required()
      ->allow_extra_args(false)
      ->type_name("KEY=LOW:HIGH");
  addMesh(*command, options->mesh, "Mesh of the search (default: tiny)");
  addMesh(*command, options->confirm, "Mesh on which the best points are computed again (default: draft)", "--confirm");
  command
      ->add_option("--evaluations", options->evaluations,
                   "Points to compute, about (default: 20 plus 40 for each input)")
      ->check(CLI::Range(10, 100000))
      ->type_name("N");
  command->add_option("-o,--output", options->calibration.folder, "Folder of the results (default: current folder)")
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: as many as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  addThreads(*command, options->threads, "Threads of each run (default: cores / jobs)");
  addInstructionSet(*command, options->calibration.isa);
  addFigureOptions(*command, options->figures);
  command
      ->add_option("--partition", options->partition,
                   "Compute only the M-th of N parts (slice or hash) of the points that fill the limits; the call "
                   "without it takes what all parts have computed, and continues the search")
      ->type_name("KIND:M/N");
  command->footer(
      "Every point is kept in calibration.csv; the same command in the same folder resumes.\n"
      "Exit code 4: a target is out of reach within the limits.");
  command->callback([options, &action] { action = [options] { return calibrate(*options); }; });
}

}  // namespace squat::commands
