// solver/analysis/Maps.h - a signal over time and frequency, in the one way in which runs, files and the studio show
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signals/ContinuousWavelet.h"
#include "signals/Stft.h"

namespace squat::analysis {

// Segment 0: 10 ms; none where the record is shorter. Hop 0: at most 2000 columns. `notes` says what was left out.
// Throws SignalError as signals::shortTimeTransform.
std::optional<signals::Stft> stftMap(const signals::TimeSeries& series, signals::StftOptions options,
                                     std::vector<std::string>& notes);

// Cell 0: at most 2000 columns of what is shown. The highest frequency is lowered to half the rate, the lowest raised
// to one wave in the record and 1e-5 of the rate, the voices lowered to 1000 rows; `notes` says so. Throws SignalError.
signals::Scalogram scalogramMap(const signals::TimeSeries& series, signals::WaveletOptions options,
                                std::vector<std::string>& notes);

}  // namespace squat::analysis
