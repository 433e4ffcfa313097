// solver/measured/SampledColumns.h - from the columns of one run to a uniformly sampled signal with positions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measured/SignalFile.h"

namespace squat::measured {

// One run in SI units, all columns of equal length; time, position and speed empty where the file has none.
struct SampledColumns {
  std::string file, run, name, unit;
  std::vector<double> signal, time, position, speed;
  std::function<std::string(std::size_t)> place;  // of a row, for messages: "line 12"
};

// Throws FileError as readSignals says.
signals::Record toRecord(SampledColumns columns, const SignalFileOptions& options);

}  // namespace squat::measured
