// widgets/studio/project/ProjectRuns.h - runs and measured signals of the list as entries of a project, and back.
#pragma once

#include <QStringList>
#include <vector>

#include "project/Project.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// What a project keeps of the list: what is in no file yet is left out.
void listRuns(const RunStore& store, project::Project& project);

// The files of the entries, in their order; what cannot be read is listed as missing. `problems` gets a sentence for
// each file that is missing, or holds something else than it did.
std::vector<StoredRun> openRuns(const project::Project& project, QStringList& problems);

}  // namespace squat::studio
