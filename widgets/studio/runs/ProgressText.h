// widgets/studio/runs/ProgressText.h - how far a computation is, in words.
#pragma once

#include <QString>

#include "core/Monitor.h"

namespace squat::studio {

// "3 min 20 s"; "unknown" below zero.
QString durationText(double seconds);

// "rolling 42 %, 3 min 20 s left"
QString progressText(const Progress& progress);

}  // namespace squat::studio
