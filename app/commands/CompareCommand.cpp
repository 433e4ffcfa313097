#include <cmath>
#include <cstdio>
#include <filesystem>

#include "analysis/ComparisonFiles.h"
#include "analysis/FileComparison.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

using text::roundedText;
using text::TextTable;

struct CompareOptions {
  std::string result, folder, resultColumn;
  std::vector<std::string> measured;
  SignalOptions signal;
  analysis::FileComparisonOptions comparison;
  FigureChoice figures;
};

void printComparison(const analysis::FileComparison& pair) {
  const auto& comparison = pair.comparison;
  std::printf("%s against %s (%s)\n", comparison.firstName.c_str(), comparison.secondName.c_str(),
              pair.secondFile.c_str());
  for (const auto* features : {&comparison.firstFeatures, &comparison.secondFeatures})
    std::printf("  features of %s anchored at: %s, %s\n", features->name.c_str(),
                signals::toText(features->anchor).c_str(), roundedText(1e3 * features->impactTime, "ms").c_str());
  TextTable table({"quantity", "value"});
  for (const auto& [name, value] : signals::comparisonRow(comparison))
    table.add({text::withPrintedUnit(name), std::isnan(value) ? "-" : roundedText(value)});
  std::printf("%s", table.text().c_str());
  for (const auto& note : pair.notes) std::printf("note: %s\n", note.c_str());
  std::printf("\n");
}

int compare(const CompareOptions& given) {
  auto options = given.comparison;
  options.second = fileOptions(given.signal);
  // Another file of signals is read as the measured ones are; a result file says itself what it holds.
  if (std::filesystem::path(given.result).extension() != ".h5") options.first = options.second;
  options.first.column = given.resultColumn;
  options.first.speed = options.second.speed;
  options.comparison.align = !options.smooth;

  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  const auto pairs = analysis::compareFiles(given.result, given.measured, options, monitor);
  monitor.clearLine();
  for (const auto& pair : pairs) printComparison(pair);
  if (InterruptGuard::asked()) return kCancelled;
  if (given.folder.empty()) return kDone;
  const auto tables = analysis::writeComparisons(pairs, given.folder);
  std::printf("written:\n");
  for (const auto& path : tables) std::printf("  %s\n", path.c_str());
  for (const auto& path : writeComparisonFigures(pairs, options.smooth, given.folder, given.figures))
    std::printf("  %s\n", path.c_str());
  return kDone;
}

}  // namespace

void addCompareCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("compare", "Compare a computed signal with measured ones, or with its run on smooth rail");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("result", options->result, "Result file (or any signal)")->required()->type_name("RESULT.h5");
  command->add_option("measured", options->measured, "CSV, HDF5 or MATLAB files")->required()->type_name("MEASURED...");
  command->add_option("-o,--output", options->folder, "Folder for tables and figures (default: print only)")
      ->type_name("DIR");
  command->add_option("--result-column", options->resultColumn, "Signal of the result (default: aba)")
      ->type_name("NAME");
  addSignalOptions(*command, options->signal);
  command
      ->add_option("--low-pass", options->comparison.lowPass,
                   "Zero-phase low-pass filter for both; 0: none (default: 2000)")
      ->check(between(0.0, 1e7))
      ->type_name("HZ");
  addFigureOptions(*command, options->figures);
  command->add_flag("--by-position", options->comparison.comparison.inPosition, "Align by position instead of time");
  command->add_flag("--smooth", options->comparison.smooth,
                    "The others are runs on the same track without the defect: no alignment");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace squat::commands
