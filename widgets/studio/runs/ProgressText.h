// widgets/studio/runs/ProgressText.h - how far a computation is, in words.
#pragma once

#include <QString>

#include "core/Monitor.h"
#include "results/RunResult.h"

namespace squat::studio {

// "3 min 20 s"; "unknown" below zero.
QString durationText(double seconds);

// "rolling 42 %, 3 min 20 s left"
QString progressText(const Progress& progress);

// "Done in 23 s: axle box acceleration -98 to 112 m/s², contact force up to 131 kN." Without what the result lacks; of
// a run that was resumed, "Done, 4 s after it was resumed". Of several wheels, those that lift off are named.
QString completionText(const results::RunResult& result, bool resumed = false);

}  // namespace squat::studio
