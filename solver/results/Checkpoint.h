// solver/results/Checkpoint.h - the state of a run on disk, to resume from after a kill.
// A checkpoint is an ArrayTree whose root carries the attributes `schema` = "squat-checkpoint" and `schema_version`;
// whoever writes one adds what must agree to resume (case hash, instruction set, code version) as root attributes.
#pragma once

#include <optional>
#include <string>

#include "results/ArrayTree.h"

namespace squat::results {

inline constexpr int kCheckpointVersion = 1;

// Replaces the checkpoint under `path` whole or not at all; the one before stays as PATH.previous.
// Refuses a state with a not-a-number or an infinity (FileError naming the array), so a good checkpoint is never
// replaced by a diverged one. FileError as well where the file cannot be written; the earlier one then stays.
void writeCheckpoint(const std::string& path, ArrayTree state);

// The state under `path`, or under PATH.previous where `path` is missing or damaged (`usedPrevious`).
// No value where neither exists; FileError where none of the existing ones is whole, or it is of a newer version.
std::optional<ArrayTree> readCheckpoint(const std::string& path, bool* usedPrevious = nullptr);

// Removes the checkpoint and its predecessor: the run is complete.
void removeCheckpoint(const std::string& path);

}  // namespace squat::results
