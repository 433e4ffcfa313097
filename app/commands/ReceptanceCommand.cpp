#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "case/Resolve.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/PaperTable.h"
#include "commands/TerminalMonitor.h"
#include "commands/TextTable.h"
#include "core/DurableFile.h"
#include "receptance/ReceptanceFiles.h"

namespace squat::commands {

namespace {

struct ReceptanceCommandOptions {
  CaseOptions caseOptions;
  std::string folder = ".";
  receptance::ReceptanceOptions receptance;
  FigureChoice figures;
};

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void print(const receptance::TrackReceptance& result) {
  std::vector<std::string> head{"frequency"};
  for (const auto& point : result.points) head.push_back(point.name), head.push_back("phase");
  TextTable table(head);
  for (const double f : {50.0, 82.0, 100.0, 300.0, 500.0, 1000.0, 1500.0, 2000.0}) {
    const double step = result.frequency.size() > 1 ? result.frequency[1] - result.frequency[0] : 1;
    const auto i = std::lround((f - result.frequency.front()) / step);
    if (i < 0 || i >= static_cast<long>(result.frequency.size())) continue;
    std::vector<std::string> row{format("%.0f Hz", result.frequency[i])};
    for (const auto& point : result.points) {
      row.push_back(format("%.3e m/N", std::abs(point.receptance[i])));
      row.push_back(format("%.0f°", std::arg(point.receptance[i]) * 180 / std::numbers::pi));
    }
    table.add(row);
  }
  std::printf("%s\n", table.text().c_str());
  for (const auto& point : result.points) {
    std::printf("resonances %s [Hz]:", point.name.c_str());
    for (const double f : receptance::resonances(result.frequency, point.receptance)) std::printf(" %.0f", f);
    std::printf("\n");
  }
  std::printf("\nNatural modes of the free half wheelset:\n%s", modesTable(result.modes).c_str());
  for (const auto& note : result.notes) std::printf("note: %s\n", note.c_str());
}

int run(const ReceptanceCommandOptions& options) {
  const auto description = readCase(options.caseOptions);
  const auto name = stemOf(options.caseOptions), stem = options.folder + "/" + name;
  const std::vector<std::string> tables{stem + "-receptance.h5", stem + "-receptance.csv",
                                        stem + "-wheelset-modes.csv"};
  keepInputs(cases::filesOfCase(options.caseOptions.name, description.defect.file), tables);
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  const auto result = receptance::trackReceptance(cases::resolve(description), options.receptance, monitor);
  monitor.clearLine();
  if (!result.complete) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  print(result);
  receptance::writeReceptance(tables[0], result, cases::writeCase(description));
  writeDurably(tables[1], receptance::receptanceCsv(result));
  writeDurably(tables[2], receptance::modesCsv(result));
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
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace squat::commands
