// solver/signals/Butterworth.h - Butterworth filters without phase shift: the record passes forward and back.
#pragma once

#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

// y[i] = b0 x[i] + b1 x[i-1] + b2 x[i-2] - a1 y[i-1] - a2 y[i-2]
struct SecondOrderSection {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

// Digital Butterworth filters by the bilinear transform with the edge frequencies prewarped, as SciPy's butter gives
// them. `order` 1..12 is that of the low-pass prototype (a band-pass has twice as many poles); edges are -3 dB points
// in Hz, inside (0, rate/2). Throws SignalError for edges outside.
std::vector<SecondOrderSection> butterworthLowPass(int order, double cutoff, double rate);
std::vector<SecondOrderSection> butterworthBandPass(int order, double low, double high, double rate);

// Forward and back through the sections (so -6 dB at the edges and no delay), with the record continued at both ends
// by its odd reflection over 3 (2 n + 1) samples and every section started in its steady state: SciPy's sosfiltfilt.
// Throws SignalError where the record is not longer than that.
std::vector<double> filterForwardBack(const std::vector<SecondOrderSection>& sections,
                                      const std::vector<double>& values);

// The two together on a series; name and unit stay.
TimeSeries lowPass(const TimeSeries& series, double cutoff, int order = 4);
TimeSeries bandPass(const TimeSeries& series, double low, double high, int order = 4);

// Amplitude gain of one pass at a frequency [Hz].
double gainAt(const std::vector<SecondOrderSection>& sections, double frequency, double rate);

}  // namespace squat::signals
