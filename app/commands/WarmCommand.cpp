#include <cstdio>

#include "case/ParameterValue.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/RunFiles.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "simulation/WarmStateFile.h"

namespace squat::commands {

namespace {

struct WarmCommandOptions {
  CaseOptions caseOptions;
  std::string folder = ".";
  simulation::RunOptions run;
};

void printWarmState(const std::string& path, const simulation::WarmState& warm) {
  const auto zone = [&](const char* key) { return cases::valueText(warm.description, *cases::findParameter(key)); };
  std::printf("The wheel stands %.1f mm before the deepest point of the defect.\n", -1e3 * warm.position);
  std::printf("Serves defects from -%s to %s mm (mesh.zone_before, mesh.zone_behind).\n",
              zone("mesh.zone_before").c_str(), zone("mesh.zone_behind").c_str());
  std::printf("written: %s (%.1f MB)\n", path.c_str(), 1e-6 * static_cast<double>(byteCount(warm)));
}

int warm(const WarmCommandOptions& options) {
  const auto description = readCase(options.caseOptions);
  const RunFiles files{options.folder, stemOf(options.caseOptions)};
  keepInputs(cases::filesOfCase(options.caseOptions.name, description), {files.warmState()});
  const OutputFolder folder(options.folder);
  prepareFolder(files);
  const FolderLock owner(options.folder, "squat warm " + options.caseOptions.name);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  const auto made = simulation::makeWarmState(description, options.run, monitor);
  monitor.clearLine();
  if (!made) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  simulation::writeWarmState(files.warmState(), *made);
  printWarmState(files.warmState(), *made);
  return kDone;
}

}  // namespace

void addWarmCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "warm", "Keep the state just before the defect: squat run --warm starts there with any defect");
  auto options = std::make_shared<WarmCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions);
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addThreads(*command, options->run.threads);
  addInstructionSet(*command, options->run.isa);
  command->callback([options, &action] { action = [options] { return warm(*options); }; });
}

}  // namespace squat::commands
