// widgets/studio/runs/AutomaticAlignment.h - measured signals follow the run that is shown.
#pragma once

#include "studio/runs/RunStore.h"

namespace squat::studio {

// Lays those that the user has not laid by hand where they match the current run. Those that are unlike it, those of
// files above 20 MB and those of files that cannot be read any more stay where they are; so do all where the run was
// stopped.
void alignWithCurrent(RunStore& store);

}  // namespace squat::studio
