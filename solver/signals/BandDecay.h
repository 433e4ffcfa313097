// solver/signals/BandDecay.h - how long a band rings after an impact, beside how long the filter itself rings.
// A narrow filter rings by itself, so a duration alone does not tell a vibration from a kick; the two together do.
#pragma once

#include <complex>

#include "signals/Features.h"
#include "signals/TimeSeries.h"

namespace squat::signals {

struct BandDecay {
  double duration = 0;   // [s] from the envelope's largest value until it stays below the level for half of `own`
  double own = 0;        // [s] the same of the filter's answer to a kick of no length
  bool ended = true;     // false: the record ends before the vibration does, `duration` is its minimum
  double frequency = 0;  // [Hz] of what rings, mean by power from one `own` after the top on: a strong line beside the
                         // band passes its flanks
  double ratio() const {
    return duration / own;
  }  // 1: a kick; a vibration that fades like exp(-t/T) tends to
     // T ln(1/level) / own
};

// The envelope is the magnitude of the analytic signal of the record behind a zero-phase Butterworth band-pass (order
// 4, forward and back), looked at from `from` to `to` [s], but not within half of `own` of the record's end: there the
// filter sees what it makes up beyond. Throws SignalError for a band that the sampling rate cannot
// show, for a level outside 0 to 1, and where the record has no sample between `from` and `to`.
BandDecay bandDecay(const TimeSeries& series, double from, double to, const Band& band, double level = 0.1);

// The record and, as imaginary part, its Hilbert transform; zeros are taken beyond its ends.
std::vector<std::complex<double>> analyticSignal(const TimeSeries& series);
// Magnitude of the analytic signal: the envelope of a narrow-banded record.
std::vector<double> envelope(const TimeSeries& series);

}  // namespace squat::signals
