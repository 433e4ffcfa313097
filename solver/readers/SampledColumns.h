// solver/readers/SampledColumns.h - from the columns of one run to a uniformly sampled signal with positions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "readers/SignalFile.h"

namespace squat::readers {

// One run in SI units, all columns of equal length; time, position and speed empty where the file has none.
struct SampledColumns {
  std::string file, run, name, unit;
  std::vector<double> signal, time, position, speed;
  std::function<std::string(std::size_t)> location;  // of a row, for messages: "line 12"
};

// Throws FileError as readSignals says.
signals::Record toRecord(SampledColumns columns, const SignalFileOptions& options);

}  // namespace squat::readers
