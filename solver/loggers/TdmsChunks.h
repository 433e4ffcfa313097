// solver/loggers/TdmsChunks.h - how the values of several channels follow each other within a segment of a TDMS file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "loggers/TdmsObjects.h"

namespace squat::loggers {

struct TdmsStretch {
  std::size_t begin = 0, end = 0;  // [bytes] of the values
  bool bigEndian = false, interleaved = false;
  bool closed = true;  // its length was written; else the last chunk may end anywhere
};

// Hands out the values of the objects of `layout`, run by run, and returns how many bytes at the end fill no whole
// block. An object whose values cannot be told apart gets its `refusal`. Throws FileError for values that belong to
// nothing and for a layout that cannot be.
std::uint64_t tdmsValuesIn(const TdmsStretch& stretch, std::string_view bytes, const std::string& path,
                           const std::vector<std::size_t>& layout, std::vector<TdmsObject>& objects,
                           const std::function<void(std::size_t, const TdmsRun&)>& sink);

}  // namespace squat::loggers
