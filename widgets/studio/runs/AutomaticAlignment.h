// widgets/studio/runs/AutomaticAlignment.h - measured signals follow the run that is shown.
#pragma once

#include "studio/runs/RunStore.h"

namespace squat::studio {

// Lays those that the user has not laid by hand where they match the current run. A file that cannot be read any more
// leaves its signal as it is.
void alignWithCurrent(RunStore& store);

}  // namespace squat::studio
