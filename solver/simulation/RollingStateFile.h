// solver/simulation/RollingStateFile.h - the state of a rolling run as arrays of a checkpoint, and back.
#pragma once

#include <string>

#include "dynamics/Rolling.h"
#include "results/ArrayTree.h"
#include "simulation/RunStart.h"

namespace squat::simulation {

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree);
dynamics::RollingState loadRolling(const results::ArrayTree& tree);

// Throws FileError(file, array) where a stored state has other arrays or lengths than this run, points of contact that
// the model does not have, or a step beyond the end: it may be an untrusted file.
void requireFittingState(const StoredState& stored, const dynamics::Rolling& rolling, long lastStep);

}  // namespace squat::simulation
