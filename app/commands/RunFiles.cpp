#include "commands/RunFiles.h"

#include <filesystem>
#include <system_error>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SignalTable.h"

namespace squat::commands {

namespace {

namespace fs = std::filesystem;

bool mayBeReplacedByAPart(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return true;
  try {
    return !results::readResult(path).complete;
  } catch (const FileError&) {
    return false;  // not ours or not whole: leave it alone
  }
}

// Whether the failure is that of a checkpoint which stands there.
bool concerns(const CaseError& error) { return error.problems().front().key == "--resume"; }
bool concerns(const FileError& error, const std::string& checkpoint) {
  return error.path() == checkpoint || error.path() == checkpoint + ".previous";
}

}  // namespace

void keepInputsOfRun(const RunFiles& files, const std::string& caseName, const cases::CaseDescription& description) {
  keepInputs(cases::filesOfCase(caseName, description),
             {files.result(), files.signals(), files.partialResult(), files.partialSignals(), files.checkpoint(),
              files.checkpoint() + ".previous"});
}

std::vector<std::string> keepOtherCases(const RunFiles& files, const std::string& hash) {
  std::optional<results::ArrayTree> state;
  try {
    state = results::readCheckpoint(files.checkpoint());
  } catch (const FileError&) {
    // nothing resumes from a damaged one
  }
  if (state)
    if (const auto found = results::textAttribute(state->attributes, "case_hash", hash); found != hash)
      throw CaseError({{"-o", files.checkpoint() + " (case " + found + ")",
                        "a folder without the checkpoint of another case (this one is " + hash + ")",
                        "Choose another folder, resume that run (its case with --resume), or remove the file"}});
  std::vector<std::string> lines;
  for (const auto& path : {files.result(), files.partialResult()}) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) continue;
    try {
      if (const auto found = results::readResult(path).caseHash; found != hash)
        lines.push_back(path + " belongs to another case (" + found + "); this run (" + hash + ") replaces it");
    } catch (const FileError&) {
      // no result of this program: nothing to say about its case
    }
  }
  return lines;
}

std::optional<results::RunResult> completeResult(const RunFiles& files) {
  std::error_code ignored;
  if (!fs::exists(files.result(), ignored)) return std::nullopt;
  auto result = results::readResult(files.result());
  return result.complete ? std::optional(std::move(result)) : std::nullopt;
}

results::RunResult runOrResume(const cases::CaseDescription& description, simulation::RunOptions options,
                               const RunFiles& files, Monitor& monitor) {
  options.checkpointPath = files.checkpoint();
  options.resume = true;
  try {
    return simulation::runCase(description, options, monitor);
  } catch (const CaseError& error) {
    if (!concerns(error)) throw;
  } catch (const FileError& error) {
    if (!concerns(error, options.checkpointPath)) throw;
  }
  monitor.message(files.checkpoint() + " belongs to another case or version: the run starts from the beginning");
  results::removeCheckpoint(files.checkpoint());
  options.resume = false;
  return simulation::runCase(description, options, monitor);
}

void prepareFolder(const RunFiles& files) {
  makeFolder(files.folder);
  const auto probe = files.folder + "/." + files.stem + ".probe";
  writeDurably(probe, std::string_view("probe"));
  std::error_code ignored;
  fs::remove(probe, ignored);
}

bool canResume(const RunFiles& files) {
  std::error_code ignored;
  return fs::exists(files.checkpoint(), ignored) || fs::exists(files.checkpoint() + ".previous", ignored);
}

std::optional<std::string> writeSignalsAlone(const RunFiles& files, const results::RunResult& result) {
  try {
    results::writeSignalTable(files.partialSignals(), result);
    return files.partialSignals();
  } catch (const FileError&) {
    return std::nullopt;
  }
}

std::vector<std::string> writeRunFiles(const RunFiles& files, const results::RunResult& result) {
  const bool final = result.complete || mayBeReplacedByAPart(files.result());
  const auto resultPath = final ? files.result() : files.partialResult();
  const auto signalsPath = final ? files.signals() : files.partialSignals();
  results::writeResult(resultPath, result);
  results::writeSignalTable(signalsPath, result);
  if (result.complete) {
    std::error_code ignored;
    fs::remove(files.partialResult(), ignored);
    fs::remove(files.partialSignals(), ignored);
    results::removeCheckpoint(files.checkpoint());
  }
  return {resultPath, signalsPath};
}

}  // namespace squat::commands
