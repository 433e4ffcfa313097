// widgets/studio/project/EarlierRecovery.h - what a crash of release 0.3.0 or before left: a copy of the case and the
// results that were not saved, each in a file that names its process.
#pragma once

#include <QString>
#include <optional>

#include "project/Project.h"

namespace squat::studio {

// As a project, its results moved beside `projectFile`; those of processes that are still there stay. `open` is its
// case where only results were left. Files that cannot be read stay as well. None: nothing was left.
std::optional<project::Project> takeEarlierRecovery(const QString& folder, const QString& projectFile,
                                                    const project::OpenCase& open);

}  // namespace squat::studio
