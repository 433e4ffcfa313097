// solver/signals/ThirdOctaves.h - one-third octave bands after IEC 61260-1:2014 and their levels.
//
//   fm = 1000 Hz * G^(x/3),   edges fm * G^(-1/6) and fm * G^(1/6),   G = 10^(3/10)
//
// Nominal frequencies are those of the standard's annex E: 1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8 times a power of
// ten (from memory of the standard; exact frequencies follow from the formula). The power of a band is the integral of
// a spectrum between its edges, not the output of a filter of the standard.
#pragma once

#include <vector>

#include "signals/PowerSpectrum.h"

namespace squat::signals {

struct OctaveBand {
  double nominal = 0;              // [Hz] what the band is called
  double middle = 0;               // [Hz] exact mid-band frequency
  double lowest = 0, highest = 0;  // [Hz] its edges
};

// Those that lie within lowest..highest [Hz] as a whole, rising. Throws SignalError unless 0 < lowest and both
// are finite.
std::vector<OctaveBand> thirdOctaveBands(double lowest, double highest);

// 10 log10 of the power in each band over the square of the reference [dB]; 1e-6 m/s2 is that of ISO 1683 for
// acceleration. Minus infinity for a band without power. Throws SignalError as bandPower().
std::vector<double> bandLevels(const PowerSpectrum& spectrum, const std::vector<OctaveBand>& bands,
                               double reference = 1e-6);

}  // namespace squat::signals
