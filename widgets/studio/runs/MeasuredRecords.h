// widgets/studio/runs/MeasuredRecords.h - measured signals, ready to be laid over a run.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "readers/SignalFile.h"

namespace squat::studio {

using RecordPointer = std::shared_ptr<const signals::Record>;

// Reads measured axle box accelerations, one or more runs, as "aba" and "aba_filtered" (low-passed at 2 kHz where the
// rate allows), and puts the largest value of each where that of `reference` is (at the defect without one). Only 5 m
// on both sides of it are kept. Where neither file nor options give a speed, `speed` [m/s] links time and position.
// Throws FileError, also for signals that are no accelerations.
std::vector<RecordPointer> measuredRecords(const QString& path, double speed, const signals::Record* reference,
                                           const readers::SignalFileOptions& options = {});

}  // namespace squat::studio
