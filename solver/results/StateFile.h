// solver/results/StateFile.h - the state of a run in a file of this program: a checkpoint or a warm state. An ArrayTree
// whose root carries the attributes `schema` and `schema_version`, in the binary format of TreeStream.h.
#pragma once

#include <string>

#include "core/DurableFile.h"
#include "results/ArrayTree.h"

namespace squat::results {

struct StateKind {
  const char* schema;  // "squat-checkpoint"
  int version;
  const char* name;       // "a checkpoint"
  const char* insteadOf;  // what to do where the file cannot be used: "start the run again without --resume"
};

// Puts the state under `path` whole or not at all, read back before the earlier file is replaced. Refuses a state with
// a not-a-number or an infinity (FileError naming the array). FileError as well where the file cannot be written.
void writeState(const std::string& path, ArrayTree state, const StateKind& kind, Previous previous);

// Throws FileError for a file that is missing, damaged, of another kind or of a newer version.
ArrayTree readState(const std::string& path, const StateKind& kind);

// With a capital letter in front: advice made of StateKind::insteadOf.
std::string asSentence(std::string text);

}  // namespace squat::results
