// solver/core/PartFile.h - what is written beside its place until it is whole, and what processes that were killed have
// left of it.
#pragma once

#include <string>

namespace squat {

// The name under which a file or folder is written before it takes its own: PATH.part-PID.
std::string partName(const std::string& path);

// Removes PATH.part-PID, file or folder, of processes that no longer run.
void removeLeftOvers(const std::string& path);

}  // namespace squat
