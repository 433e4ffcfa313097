// solver/simulation/RollingStateFile.h - the state of a rolling run as arrays of a checkpoint, and back: /rolling, and
// /rolling_right where there is a right side.
#pragma once

#include <string>

#include "dynamics/Rolling.h"
#include "results/ArrayTree.h"
#include "simulation/RunStart.h"

namespace squat::simulation {

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree);
// Restores every side of a rolling run. Call requireFittingState() before.
void restoreRolling(const results::ArrayTree& tree, dynamics::Rolling& rolling);

// Throws FileError(file, array) where a stored state has other arrays or lengths than this run, points of contact that
// the model does not have, or a step beyond the end: it may be an untrusted file.
void requireFittingState(const StoredState& stored, const dynamics::Rolling& rolling, long lastStep);

}  // namespace squat::simulation
