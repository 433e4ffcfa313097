// widgets/studio/project/ProjectRuns.h - runs and measured signals of the list as entries of a project, and back.
#pragma once

#include <QString>

#include "project/Project.h"
#include "results/ResultFile.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// What a project keeps of the list: what is in no file yet is left out.
void listRuns(const RunStore& store, project::Project& project);

// The link to a run or a measured signal that is in a file.
project::Entry entryOf(const StoredRun& run);

// As it stands in the list before its file is read.
StoredRun listedRun(const project::Entry& entry);

// What the file of an entry holds; without a record where it cannot be read. `problem` gets a sentence where it is
// missing, or holds something else than it did. May be called in any thread.
StoredRun openEntry(const project::Entry& entry, results::ResultContent content, QString& problem);

}  // namespace squat::studio
