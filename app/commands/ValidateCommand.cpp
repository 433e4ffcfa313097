#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/RunFiles.h"
#include "commands/TerminalMonitor.h"
#include "commands/ValidationText.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "statements/Judge.h"
#include "statements/PaperCase.h"
#include "statements/Sensitivity.h"

namespace squat::commands {

namespace {

struct ValidateOptions {
  std::string folder = ".", mesh = "draft", reference, from;
  simulation::RunOptions run;
  FigureChoice figures;
  bool sensitivity = false;
};

using Results = std::map<std::string, results::RunResult>;

// The finished result of this very case by this version of the program, where it stands already. Throws CaseError for a
// result of another case, which is not to be lost.
std::optional<results::RunResult> finishedOfCase(const RunFiles& files, const std::string& hash) {
  auto result = completeResult(files);
  if (result && result->caseHash != hash)
    throw CaseError({{"-o", files.result() + " (case " + result->caseHash + ")", "the same case (" + hash + ")",
                      "Made from another case or mesh: choose another folder, or judge it with --from"}});
  return result && result->codeVersion == programVersion() ? result : std::nullopt;
}

std::optional<results::RunResult> make(const ValidateOptions& options, const statements::ReferenceRun& run,
                                       TerminalMonitor& monitor) {
  const auto description = run.caseOn(options.mesh);
  const RunFiles files{options.folder, run.name};
  if (auto result = finishedOfCase(files, cases::caseHash(description))) {
    monitor.message("using existing " + files.result());
    return result;
  }
  monitor.message("running " + run.name);
  auto result = runOrResume(description, options.run, files, monitor);
  if (!result.complete) return std::nullopt;
  result.stem = files.stem;
  writeRunFiles(files, result);
  return result;
}

// Makes the runs that do not stand there yet. False where one of them failed.
bool makeAll(const ValidateOptions& options, const statements::Reference& reference, Results& results,
             TerminalMonitor& monitor) {
  bool well = true;
  // Hours later would be the wrong moment to find a foreign result, or the checkpoint of another case.
  for (const auto& run : reference.runs) {
    const auto description = run.caseOn(options.mesh);
    const RunFiles files{options.folder, run.name};
    keepInputsOfRun(files, run.caseName, description);
    if (!finishedOfCase(files, cases::caseHash(description))) keepOtherCases(files, cases::caseHash(description));
  }
  for (const auto& run : reference.runs) {
    try {
      if (auto result = make(options, run, monitor)) results.emplace(run.name, std::move(*result));
    } catch (const RunError& error) {
      monitor.message("run " + run.name + " failed: " + error.what());
      well = false;
    }
    if (InterruptGuard::asked()) break;
  }
  return well;
}

// What stands in a folder, whatever mesh or version made it; says where it is not what the reference asks for. Returns
// the mesh preset of the results.
std::string readAll(const ValidateOptions& options, const statements::Reference& reference, Results& results,
                    TerminalMonitor& monitor) {
  std::string mesh;
  for (const auto& run : reference.runs) {
    const RunFiles files{options.from, run.name};
    std::error_code ignored;
    if (!std::filesystem::exists(files.result(), ignored)) {
      monitor.message(files.result() + " not found: its statements are not judged");
      continue;
    }
    auto result = results::readResult(files.result());
    if (!result.complete) {
      monitor.message(files.result() + " is incomplete (" + result.stopReason + "): its statements are not judged");
      continue;
    }
    const auto own = statements::meshPresetOf(result);
    if (mesh.empty()) mesh = own;
    if (own != mesh) monitor.message(files.result() + " uses the mesh " + own + ", the others " + mesh);
    if (cases::caseHash(run.caseOn(own)) != result.caseHash)
      monitor.message(files.result() + " differs from the reference case: judged as it is");
    results.emplace(run.name, std::move(result));
  }
  if (results.empty())
    throw FileError(options.from, "", "contains none of the results that the statements refer to",
                    "Give the folder written by squat validate -o, or leave out --from to make the runs");
  return mesh;
}

int judgeAndWrite(const ValidateOptions& options, const statements::Reference& reference, const Results& results,
                  const std::string& mesh) {
  const auto judged = statements::judge(reference, results, mesh);
  std::string text = "Mesh " + mesh + ". " + countsText(judged) +
                     ".\nJudged at the axle box. validation.csv adds the paper's wording, the runs, the reasons for "
                     "the\naccepted ranges and the values at the wheel centre.\n\n" +
                     statementsText(judged) + "\n";
  std::vector<std::string> written;
  const auto write = [&](const std::string& name, const std::string& content) {
    written.push_back(options.folder + "/" + name);
    writeDurably(written.back(), std::string_view(content));
  };
  if (const auto light = results.find(reference.runs.front().name); light != results.end()) {
    const auto parameters = statements::compareParameters(reference, light->second);
    text += parametersText(parameters) + "\n";
    write("validation_parameters.csv", statements::parametersCsv(parameters));
  }
  std::printf("%s%s\n", text.c_str(), countsText(judged).c_str());
  write("validation.txt", text + numbersText(reference));
  write("validation.csv", statements::judgedCsv(judged));
  for (auto& path : writeValidationFigure(judged, "mesh " + mesh, options.folder, options.figures))
    written.push_back(std::move(path));
  std::printf("\nwritten:\n");
  for (const auto& path : written) std::printf("  %s\n", path.c_str());
  return kDone;
}

int showSensitivity(const ValidateOptions& options, const statements::Reference& reference, TerminalMonitor& monitor) {
  cases::CaseOverrides overrides;
  overrides.preset = options.mesh;
  auto runOptions = options.run;
  runOptions.wheelsetModes = runOptions.snapshots = false;
  const studies::CaseRunner run = [&](const cases::CaseDescription& description, const studies::StudyPoint&,
                                      Monitor& own) { return simulation::runCase(description, runOptions, own); };
  const auto table =
      statements::sensitivity(reference, overrides, run, {options.folder + "/sensitivity", 1, false}, monitor);
  monitor.clearLine();
  const std::string text =
      "Mesh " + options.mesh + ", run " + reference.sensitivityRun + "\n\n" + sensitivityText(table);
  std::printf("%s", text.c_str());
  writeDurably(options.folder + "/sensitivity.txt", std::string_view(text));
  writeDurably(options.folder + "/sensitivity.csv", std::string_view(statements::sensitivityCsv(table)));
  std::printf("\nwritten:\n  %s/sensitivity.txt\n  %s/sensitivity.csv\n", options.folder.c_str(),
              options.folder.c_str());
  const bool failed = std::any_of(table.rows.begin(), table.rows.end(),
                                  [](const auto& row) { return !row.message.empty() && row.message != "not run"; });
  return failed ? kRunFailed : kDone;
}

int cancelled() {
  std::fprintf(stderr, "cancelled: repeat the command to resume\n");
  return kCancelled;
}

int validate(const ValidateOptions& options) {
  const auto reference =
      statements::readReference(options.reference.empty() ? statements::paperReferencePath() : options.reference);
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  if (options.sensitivity) {
    const int code = showSensitivity(options, reference, monitor);
    return InterruptGuard::asked() ? cancelled() : code;
  }
  Results results;
  if (!options.from.empty()) {
    const auto mesh = readAll(options, reference, results, monitor);
    return judgeAndWrite(options, reference, results, mesh);
  }
  const bool well = makeAll(options, reference, results, monitor);
  monitor.clearLine();
  if (InterruptGuard::asked()) return cancelled();
  const int code = judgeAndWrite(options, reference, results, options.mesh);
  return well ? code : kRunFailed;
}

}  // namespace

void addValidateCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("validate", "Make the paper's runs and judge its statements one by one");
  auto options = std::make_shared<ValidateOptions>();
  command->add_option("-o,--output", options->folder, "Folder for results, tables and figure (default: current folder)")
      ->type_name("DIR");
  auto* mesh = addMesh(*command, options->mesh, "Mesh preset (default: draft)");
  auto* from = command->add_option("--from", options->from, "Judge existing results in this folder; make no runs")
                   ->type_name("DIR")
                   ->excludes(mesh);
  command
      ->add_flag("--sensitivity", options->sensitivity,
                 "Instead: results of the light defect with one input changed at a time (more runs)")
      ->excludes(from);
  command->add_option("--reference", options->reference, "File of statements (default: those of the paper)")
      ->type_name("FILE.json");
  addThreads(*command, options->run.threads);
  addInstructionSet(*command, options->run.isa);
  addFigureOptions(*command, options->figures);
  command->callback([options, &action] { action = [options] { return validate(*options); }; });
}

}  // namespace squat::commands
