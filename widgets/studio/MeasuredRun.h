// widgets/studio/MeasuredRun.h - a measured signal as a run that can be overlaid.
#pragma once

#include <QString>
#include <memory>

#include "results/RunResult.h"

namespace squat::studio {

// Reads a measured axle box acceleration and puts its largest value where that of `reference` is (at the defect without
// one). Only 5 m on both sides of it are kept. Where the file tells no speed, `speed` [m/s] links time and position.
// Throws FileError.
std::shared_ptr<const results::RunResult> measuredRun(const QString& path, double speed,
                                                      const results::RunResult* reference);

}  // namespace squat::studio
