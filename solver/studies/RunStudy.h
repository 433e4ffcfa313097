// solver/studies/RunStudy.h - many runs, one table; resumed where it was interrupted.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "core/Monitor.h"
#include "studies/PartLock.h"
#include "studies/StudyProgress.h"
#include "studies/StudyTable.h"

namespace squat::studies {

struct StudyOptions {
  std::string folder;                          // where study.csv and study.json stand; made where missing
  int jobs = 1;                                // runs at once
  bool retryFailed = false;                    // run those again that failed before
  std::optional<Partition> part = {};          // only the points of this part, into a table of its own
  std::chrono::milliseconds beat = kPartBeat;  // of the part's lock
  // Called whenever a run begins, advances or ends, on the computing threads, one call at a time. Must return soon.
  StudyWatcher watcher = {};
};

// One run of the study. Returns its features, nothing where it was cancelled through the monitor; throws where it
// failed. With several jobs it is called from several threads at once, each with a monitor of its own.
using StudyRunner = std::function<std::optional<FeatureRow>(const StudyPoint&, Monitor&)>;

// Runs every point that the folder's table does not have yet and writes the table after each. A run that throws (any
// exception) becomes a failed row with its message; the others go on. Cancelling stops at the runs under way: they stay
// open, and the next call resumes there. Reports progress and, as messages, each run's end. Throws CaseError and
// FileError for the study itself, never for a single run.
//
// Parts of one study may run at the same time in one folder, on several machines; a part that another process computes
// is refused by CaseError with that one's name (PartLock.h). A study without parts is not locked here.
StudyTable runStudy(const StudyDefinition& definition, const StudyRunner& runner, const StudyOptions& options,
                    Monitor& monitor);

}  // namespace squat::studies
