#include <unistd.h>

#include <cstdio>

#include "case/Resolve.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "receptance/ReceptanceFiles.h"
#include "receptance/ReceptanceSummary.h"

namespace squat::commands {

namespace {

struct ReceptanceCommandOptions {
  CaseOptions caseOptions;
  std::string folder = ".";
  receptance::ReceptanceOptions receptance;
  FigureChoice figures;
};

int computeReceptance(const ReceptanceCommandOptions& options) {
  const auto description = readCase(options.caseOptions);
  const auto name = stemOf(options.caseOptions), stem = options.folder + "/" + name;
  const auto tables = receptance::receptanceFiles(stem);
  keepInputs(cases::filesOfCase(options.caseOptions.name, description), tables);
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  const auto result = receptance::trackReceptance(cases::resolve(description), options.receptance, monitor);
  monitor.clearLine();
  if (!result.complete) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  std::printf("%s", receptance::receptanceSummary(result).c_str());
  receptance::writeReceptanceFiles(stem, result, cases::writeCase(description));
  std::printf("\nwritten:\n");
  for (const auto& path : tables) std::printf("  %s\n", path.c_str());
  for (const auto& path : writeReceptanceFigure(result, name + "-receptance", description.title,
                                                cases::caseHash(description), options.folder, options.figures))
    std::printf("  %s\n", path.c_str());
  return kDone;
}

}  // namespace

void addReceptanceCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("receptance", "Compute the track receptance and the natural modes of the half wheelset");
  auto options = std::make_shared<ReceptanceCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions);
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addThreads(*command, options->receptance.threads);
  addFigureOptions(*command, options->figures);
  command->callback([options, &action] { action = [options] { return computeReceptance(*options); }; });
}

}  // namespace squat::commands
