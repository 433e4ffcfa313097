// solver/simulation/RollingStateFile.h - the state of a rolling run as arrays of a checkpoint, and back.
#pragma once

#include <string>

#include "dynamics/Rolling.h"
#include "results/ArrayTree.h"

namespace squat::simulation {

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree);
dynamics::RollingState loadRolling(const results::ArrayTree& tree);

// Throws FileError(file, array) where a stored state has other arrays or lengths than this run, points of contact that
// the model does not have, or a step beyond the end: a checkpoint may be an untrusted file.
void requireFittingState(const results::ArrayTree& tree, const dynamics::Rolling& rolling, long lastStep,
                         const std::string& file);

}  // namespace squat::simulation
