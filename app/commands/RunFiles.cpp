#include "commands/RunFiles.h"

#include <filesystem>
#include <system_error>

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

}  // namespace

void prepareFolder(const RunFiles& files) {
  makeFolder(files.folder);
  const auto probe = files.folder + "/." + files.stem + ".probe";
  writeDurably(probe, std::string_view("can be written"));
  std::error_code ignored;
  fs::remove(probe, ignored);
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
