#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureOutput.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/RunFiles.h"
#include "commands/TerminalMonitor.h"
#include "core/Errors.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"

namespace squat::commands {

namespace {

constexpr std::array<const char*, 3> kCases{"light-defect", "class-c-squat", "class-c-squat-modified"};

struct PaperFigureOptions {
  std::string folder = ".", mesh;
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
std::optional<results::RunResult> finished(const RunFiles& files, const std::string& mesh) {
  const auto result = completeResult(files);
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
  if (auto result = finished(files, options.mesh)) {
    std::printf("using existing %s\n", files.result().c_str());
    return result;
  }
  for (const auto& line : keepOtherCases(files, cases::caseHash(description))) monitor.message(line);
  monitor.message("running " + name);
  auto result = runOrGoOn(description, options.run, files, monitor);
  monitor.clearLine();
  result.stem = name;
  if (!result.complete && result.time.empty()) return std::nullopt;  // nothing recorded, nothing to keep
  for (const auto& path : writeRunFiles(files, result)) std::printf("%s\n", path.c_str());
  if (!result.complete) return std::nullopt;
  return result;
}

int paper(const PaperFigureOptions& options) {
  if (!figuresAvailable())
    throw CaseError({{"figures", "headless build", "a build with SQUAT_GRAPHICS=ON",
                      "Use the full build: cmake --preset release"}});
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  std::array<std::optional<results::RunResult>, kCases.size()> found;
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    found[i] = resultOf(kCases[i], options, monitor);
    if (!found[i]) {
      std::fprintf(stderr, "cancelled: repeat the command to resume\n");
      return kCancelled;
    }
  }
  for (const auto& path : writePaperFigures({&*found[0], &*found[1], &*found[2]}, options.folder, options.figures))
    std::printf("%s\n", path.c_str());
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
  addMesh(*figures, options->mesh, "Mesh preset of the runs (default: that of the cases)");
  addThreads(*figures, options->run.threads);
  addFigureOptions(*figures, options->figures, false);
  figures->callback([options, &action] { action = [options] { return paper(*options); }; });
}

}  // namespace squat::commands
