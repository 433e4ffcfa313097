// widgets/studio/MeasuredRun.h - a measured signal as a run that can be overlaid.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "measured/SignalFile.h"
#include "results/RunResult.h"

namespace squat::studio {

// Reads measured axle box accelerations, one or more runs, and puts the largest value of each where that of `reference`
// is (at the defect without one). Only 5 m on both sides of it are kept. Where neither file nor options tell a speed,
// `speed` [m/s] links time and position. Throws FileError, also for signals that are no accelerations.
std::vector<std::shared_ptr<const results::RunResult>> measuredRuns(const QString& path, double speed,
                                                                    const results::RunResult* reference,
                                                                    const measured::SignalFileOptions& options = {});

}  // namespace squat::studio
