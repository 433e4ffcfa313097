#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/RunFiles.h"
#include "commands/TerminalMonitor.h"
#include "commands/TextTable.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "validation/Judge.h"

namespace squat::commands {

namespace {

struct ValidateOptions {
  std::string folder = ".", mesh = "draft", reference;
  simulation::RunOptions run;
};

// The finished result of this very case by this version of the program, where it stands already.
std::optional<results::RunResult> finished(const RunFiles& files, const std::string& hash) {
  std::error_code ignored;
  if (!std::filesystem::exists(files.result(), ignored)) return std::nullopt;
  try {
    auto result = results::readResult(files.result());
    if (result.complete && result.caseHash == hash && result.codeVersion == SQUAT_VERSION) return result;
  } catch (const FileError&) {  // damaged: made again
  }
  return std::nullopt;
}

std::optional<results::RunResult> make(const ValidateOptions& options, const validation::ReferenceRun& run,
                                       TerminalMonitor& monitor) {
  cases::CaseOverrides overrides;
  overrides.preset = options.mesh;
  overrides.values = run.sets;
  const auto description = cases::loadCase(run.caseName, overrides);
  const RunFiles files{options.folder, run.name};
  if (auto result = finished(files, cases::caseHash(description))) {
    monitor.message(files.result() + " stands already");
    return result;
  }
  monitor.message("run " + run.name);
  auto runOptions = options.run;
  runOptions.checkpointPath = files.checkpoint();
  runOptions.resume = true;
  auto result = simulation::runCase(description, runOptions, monitor);
  if (!result.complete) return std::nullopt;
  result.stem = files.stem;
  writeRunFiles(files, result);
  return result;
}

std::string rangeText(const validation::Statement& statement) {
  if (statement.measure == "none") return "";
  return number(statement.low) + " to " + number(statement.high, statement.unit);
}

void print(const std::vector<validation::Judged>& judged) {
  TextTable table({"section", "the paper states", "ours", "counts as met", "", "run"});
  std::map<validation::Verdict, int> counts;
  for (const auto& one : judged) {
    ++counts[one.verdict];
    const auto& s = one.statement;
    table.add({s.section, s.text, one.value ? number(*one.value, s.unit) : one.why, rangeText(s),
               validation::toText(one.verdict), s.run + (s.against.empty() ? "" : " / " + s.against)});
  }
  std::printf("%s\n%d met, %d not met, %d not judged\n", table.text().c_str(), counts[validation::Verdict::met],
              counts[validation::Verdict::notMet], counts[validation::Verdict::notJudged]);
}

int validate(const ValidateOptions& options) {
  const auto path =
      options.reference.empty() ? (cases::resourcesFolder() / "reference/paper.json").string() : options.reference;
  const auto reference = validation::readReference(path);
  const RunFiles table{options.folder, "validation"};
  prepareFolder(table);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  std::map<std::string, results::RunResult> results;
  bool failed = false;
  for (const auto& run : reference.runs) {
    try {
      if (auto result = make(options, run, monitor)) results.emplace(run.name, std::move(*result));
    } catch (const RunError& error) {
      monitor.message("run " + run.name + " failed: " + error.what());
      failed = true;
    }
    if (InterruptGuard::asked()) {
      monitor.message("cancelled: the same call goes on from here");
      return kCancelled;
    }
  }
  monitor.clearLine();
  const auto judged = validation::judge(reference, results, options.mesh);
  print(judged);
  writeDurably(table.signals(), validation::judgedCsv(judged));
  std::printf("\nwritten:\n  %s\n", table.signals().c_str());
  return failed ? kRunFailed : kDone;
}

}  // namespace

void addValidateCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("validate", "Makes the paper's runs and judges its statements one by one");
  auto options = std::make_shared<ValidateOptions>();
  command->add_option("-o,--output", options->folder, "Folder for results and table (default: here)")->type_name("DIR");
  command->add_option("--mesh", options->mesh, "Mesh preset (default: draft)")
      ->check(CLI::IsMember({"tiny", "draft", "standard", "paper"}))
      ->type_name("PRESET");
  command->add_option("--reference", options->reference, "Other statements (default: those of the paper)")
      ->type_name("FILE.json");
  command->add_option("--threads", options->run.threads, "Threads (default: all cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->add_option("--isa", options->run.isa, "Instruction set: sse2, avx2 or avx512")
      ->check(CLI::IsMember({"sse2", "avx2", "avx512"}))
      ->type_name("NAME");
  command->callback([options, &action] { action = [options] { return validate(*options); }; });
}

}  // namespace squat::commands
