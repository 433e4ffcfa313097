// widgets/studio/runs/AutomaticAlignment.h - measured signals follow the run that is shown.
#pragma once

#include "studio/runs/RunStore.h"

namespace squat::studio {

// Lays the measured signals where they match the current run. Those that were laid by hand, that are unlike the run, or
// whose files are larger than 20 MB or cannot be read any more stay where they are. A run that was stopped moves none.
void alignWithCurrent(RunStore& store);

}  // namespace squat::studio
