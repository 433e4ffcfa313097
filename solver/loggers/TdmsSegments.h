// solver/loggers/TdmsSegments.h - the segments of a TDMS file: which values of which channel stand where.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "loggers/TdmsObjects.h"

namespace squat::loggers {

struct TdmsContents {
  std::vector<TdmsObject> objects;  // in the order in which the file names them first
  std::vector<std::string> notes;
};

// Called with the number of an object and values of it, in the order of time. Text comes as a run without `first`.
using TdmsSink = std::function<void(std::size_t object, const TdmsRun& run)>;

// Walks through the file once and keeps no values, so that a first walk may count what a second one takes. The objects
// point into `bytes`. Throws FileError for a damaged file or one that is cut off; a last segment that its program could
// not close (its length is not known) is read as far as it is whole, with a note.
TdmsContents walkTdms(std::string_view bytes, const std::string& path, const TdmsSink& sink);

}  // namespace squat::loggers
