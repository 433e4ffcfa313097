#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "analysis/Analysis.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureOutput.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/RunFiles.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "core/Errors.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"

namespace squat::commands {

namespace {

constexpr std::array<const char*, 3> kCases{"light-defect", "class-c-squat", "class-c-squat-modified"};

struct PaperFigureOptions {
  std::string folder = ".", mesh;
  std::vector<std::string> measured, measuredSquat;
  SignalOptions signal;
  simulation::RunOptions run;
  FigureChoice figures;
};

std::string hashOn(const std::string& name, const std::string& mesh) {
  cases::CaseOverrides overrides;
  overrides.preset = mesh;
  return cases::caseHash(cases::loadCase(name, overrides));
}

// The finished result in the folder. With --mesh it must be this very case on that mesh; without, whatever mesh stands
// there will do. Throws CaseError for a result of another case, which is not to be overwritten.
std::optional<results::RunResult> finishedOnMesh(const RunFiles& files, const std::string& mesh) {
  auto result = completeResult(files);
  if (!result) return std::nullopt;
  // A result of an earlier version had fewer keys: its case counts as this version reads it.
  const auto& found = results::caseOf(*result).description;
  const auto own = cases::valueText(found, *cases::findParameter("mesh.preset"));
  const auto wanted = hashOn(files.stem, mesh.empty() ? own : mesh);
  if (cases::caseHash(found) != wanted)
    throw CaseError({{"-o", files.result() + " (case " + result->caseHash + ")", "the same case (" + wanted + ")",
                      "Made from another case or mesh: leave out --mesh to draw it, or choose another folder"}});
  return result;
}

std::optional<results::RunResult> resultOf(const std::string& name, const PaperFigureOptions& options,
                                           TerminalMonitor& monitor) {
  cases::CaseOverrides overrides;
  overrides.preset = options.mesh;
  const auto description = cases::loadCase(name, overrides);
  const RunFiles files{options.folder, name};
  if (auto result = finishedOnMesh(files, options.mesh)) {
    std::printf("using existing %s\n", files.result().c_str());
    return result;
  }
  for (const auto& line : keepOtherCases(files, cases::caseHash(description))) monitor.message(line);
  monitor.message("running " + name);
  auto result = runOrResume(description, options.run, files, monitor);
  monitor.clearLine();
  result.stem = name;
  if (!result.complete && result.time.empty()) return std::nullopt;  // nothing recorded, nothing to keep
  for (const auto& path : writeRunFiles(files, result)) std::printf("%s\n", path.c_str());
  if (!result.complete) return std::nullopt;
  return result;
}

// Read ahead of the runs: a wrong file is reported at once.
std::vector<analysis::SignalAnalysis> passagesOf(const std::vector<std::string>& files,
                                                 const PaperFigureOptions& options, Monitor& monitor) {
  if (files.empty()) return {};
  analysis::AnalysisOptions analysis;
  analysis.file = fileOptions(options.signal);
  analysis.align = false;
  auto found = analysis::analyse(files, analysis, monitor);
  for (const auto& signal : found.signals) {
    monitor.message(signal.file + ": " + signal.filtered.name + ", placed by its " +
                    signals::toText(signal.features.anchor));
    for (const auto& note : signal.notes) monitor.message(signal.file + ": " + note);
  }
  return std::move(found.signals);
}

int paper(const PaperFigureOptions& options) {
  if (!figuresAvailable())
    throw CaseError({{"figures", "headless build", "a build with SQUAT_GRAPHICS=ON",
                      "Use the full build: package squat-studio, or cmake --preset release"}});
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  PaperResults drawn;
  drawn.lightMeasured = passagesOf(options.measured, options, monitor);
  drawn.squatMeasured = passagesOf(options.measuredSquat, options, monitor);
  std::array<std::optional<results::RunResult>, kCases.size()> found;
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    found[i] = resultOf(kCases[i], options, monitor);
    if (!found[i]) {
      std::fprintf(stderr, "cancelled: repeat the command to resume\n");
      return kCancelled;
    }
  }
  drawn.light = &*found[0], drawn.squat = &*found[1], drawn.modified = &*found[2];
  for (const auto& path : writePaperFigures(drawn, options.folder, options.figures)) std::printf("%s\n", path.c_str());
  return kDone;
}

}  // namespace

void addFiguresCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("figures", "Draw sets of figures");
  command->require_subcommand(1);
  auto* figures = command->add_subcommand(
      "paper",
      "Draw counterparts of the paper's figures 4, 5, 6, 8, 9, 10 and 11; run the shipped cases that are missing");
  auto options = std::make_shared<PaperFigureOptions>();
  figures
      ->add_option("-o,--output", options->folder,
                   "Folder of results and figures; existing results are reused (default: current folder)")
      ->type_name("DIR");
  figures
      ->add_option("--measured", options->measured,
                   "Signals measured over the light defect, for the panels whose data the paper does not print; "
                   "repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE");
  figures->add_option("--measured-squat", options->measuredSquat, "The same over the class C squat; repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE");
  addSignalOptions(*figures, options->signal);
  addMesh(*figures, options->mesh, "Mesh preset of the runs (default: that of the cases)");
  addThreads(*figures, options->run.threads);
  addFigureOptions(*figures, options->figures, false);
  figures->callback([options, &action] { action = [options] { return paper(*options); }; });
}

}  // namespace squat::commands
