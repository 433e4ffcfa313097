// widgets/plots/ScalogramGrid.h - the scalogram of a result on an even grid for a picture.
#pragma once

#include <vector>

#include "results/AnalysedRecord.h"

namespace squat::plots {

// Power on `rows` frequencies, even in log frequency, times `columns` positions, even; row by row from the lowest.
struct ScalogramGrid {
  int rows = 0, columns = 0;
  double positionFrom = 0, positionTo = 0;    // [m]
  double frequencyFrom = 0, frequencyTo = 0;  // [Hz]
  std::vector<double> power;
  std::vector<double> cone;  // [Hz] one a column, empty where the result has none
  double largestPower = 0;
};

// The part of the scalogram within the given positions [m] and frequencies [Hz], interpolated bilinearly in position
// and log frequency. Empty where the result has no (or a broken) scalogram or nothing lies within.
ScalogramGrid scalogramGrid(const results::AnalysedRecord& result, double positionFrom, double positionTo,
                            double frequencyFrom, double frequencyTo);

}  // namespace squat::plots
