// solver/rcmdx/ExactColumns.h - datasets of one dimension, in pieces, with timestamps to the nanosecond.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/ReaderCall.h"

namespace squat::rcmdx {

// A double holds a time since 1970 to 256 ns only, so a timestamp comes as two numbers.
enum class Take {
  number,
  wholeSeconds,  // of a timestamp [ns]
  nanoseconds,   // the rest of it, 0 to 999999999
  direction      // of the words FORWARD, INCREASING, ASCENDING: 1; of their opposites: -1; of any other: 0
};

// The timestamp [ns] of both.
inline std::int64_t joinedTime(double wholeSeconds, double nanoseconds) {
  return static_cast<std::int64_t>(wholeSeconds) * 1000000000 + static_cast<std::int64_t>(nanoseconds);
}

struct ExactColumn {
  std::string path;
  Take take = Take::number;
};

// All columns have `samples` values; not-a-number where the file is cut off. The library works in a program of its own,
// as in results::streamHdf5. next() throws FileError.
std::unique_ptr<results::ArrayStream> streamExactly(const std::string& path, const std::vector<ExactColumn>& columns,
                                                    std::size_t samples);

// In the reading program: "RCM-DX columns".
void sendExactly(results::ReaderArguments& arguments, const results::ByteSink& send);

}  // namespace squat::rcmdx
