// solver/loggers/TdmsChannels.h - which channels of a TDMS file make a table: those of one group, length and rate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "loggers/TdmsScales.h"
#include "loggers/TdmsSegments.h"

namespace squat::loggers {

// What a first walk through the file found of each object.
struct TdmsCount {
  std::uint64_t values = 0;
  const TdmsType* type = nullptr;  // of its first values
};

struct TdmsChannel {
  std::size_t object = 0;  // its number
  TdmsScaling scaling;
};

struct TdmsChoice {
  std::vector<TdmsChannel> channels;
  double rate = 0;                 // [Hz] 0: not stated
  std::vector<std::string> notes;  // those of the contents first
};

// See parseTdms(). Throws FileError where nothing is left.
TdmsChoice chooseTdmsChannels(const TdmsContents& contents, const std::vector<TdmsCount>& counts,
                              const std::string& path, const std::string& group);

}  // namespace squat::loggers
