// app/commands/RunFiles.h - which files a run writes, and that a finished result is never lost to an unfinished one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "core/Monitor.h"
#include "results/RunResult.h"
#include "simulation/RunCase.h"

namespace squat::commands {

struct RunFiles {
  std::string folder, stem;
  std::string result() const { return folder + "/" + stem + ".h5"; }
  std::string signals() const { return folder + "/" + stem + ".csv"; }
  std::string partialResult() const { return folder + "/" + stem + ".partial.h5"; }
  std::string partialSignals() const { return folder + "/" + stem + ".partial.csv"; }
  std::string checkpoint() const { return folder + "/" + stem + ".checkpoint"; }
  std::string warmState() const { return folder + "/" + stem + ".warm"; }
};

// Makes the folder and sees to it that it can be written to, before hours are spent. FileError otherwise.
void prepareFolder(const RunFiles& files);

// Throws CaseError where a file of the run would take the place of what the case is read from: the case file, or the
// profile that it names.
void keepInputsOfRun(const RunFiles& files, const std::string& caseName, const cases::CaseDescription& description);

// For a run that begins anew. Throws CaseError where the checkpoint of another case's stopped run stands: hours that
// somebody may want to resume from. Returns one line for each result of another case that will be replaced.
std::vector<std::string> keepOtherCases(const RunFiles& files, const std::string& hash);

// Runs the case with checkpoints among the files. Resumes from the one that is there, if it fits; one of another
// case or version is removed, and that is reported.
results::RunResult runOrResume(const cases::CaseDescription& description, simulation::RunOptions options,
                               const RunFiles& files, Monitor& monitor);

// The complete result that stands there; nothing where there is none, or an incomplete one. FileError for a file that
// is no result or is damaged: it may be somebody's, and is not replaced unasked.
std::optional<results::RunResult> completeResult(const RunFiles& files);

// Whether a run resumes from here with --resume.
bool canResume(const RunFiles& files);

// Where the result could not be written: the signals alone, as STEM.partial.csv, which need a hundredth of the room.
// The path; nothing where they do not fit either.
std::optional<std::string> writeSignalsAlone(const RunFiles& files, const results::RunResult& result);

// Writes result and signals, and returns the paths written. A complete result replaces whatever stood there and removes
// partial files and checkpoint; an incomplete one takes the final name only where nothing or another incomplete result
// of this program stands, else STEM.partial.h5.
std::vector<std::string> writeRunFiles(const RunFiles& files, const results::RunResult& result);

}  // namespace squat::commands
