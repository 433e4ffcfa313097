// solver/results/ResultFile.h - the result file STEM.h5 (HDF5, SI units; layout in ResultTree.h).
#pragma once

#include <string>

#include "results/RunResult.h"

namespace squat::results {

// Writes the result beside `path`, reads it back, compares every bit, then renames: whatever stood under `path` stays
// until the new file is whole. Throws FileError (path, reason, bytes needed). Fields beyond what a reader accepts
// (Hdf5Limits) are thinned out, a warning in the file says so.
void writeResult(const std::string& path, const RunResult& result);

// What is read of a result. Without fields: neither surface, snapshots nor contact patches, which are nearly all of its
// bytes; they are not checked then.
enum class ResultContent { everything, withoutFields };

// Reads any result file, untrusted ones too (see Hdf5.h for what is refused). Throws FileError with the object's path.
// All lengths in what comes back fit together.
RunResult readResult(const std::string& path, ResultContent content = ResultContent::everything);

// True where `path` is a readable result that ran to its end. Never throws: false for anything else.
bool isCompleteResult(const std::string& path) noexcept;

}  // namespace squat::results
