// solver/signals/Peaks.h - local maxima with prominence and width, as SciPy's find_peaks and peak_widths define them.
#pragma once

#include <cstddef>
#include <vector>

#include "signals/PowerSpectrum.h"

namespace squat::signals {

struct Peak {
  std::size_t index = 0;  // of the sample (of a plateau: its middle, rounded down)
  double height = 0;
  double prominence = 0;       // height above the higher of the two lowest points that part it from higher ground
  double left = 0, right = 0;  // where it passes half its prominence, in samples, interpolated linearly
  double width() const { return right - left; }
};

// All maxima with at least the given prominence, in order of place. The first and the last sample are none.
std::vector<Peak> findPeaks(const std::vector<double>& values, double minimumProminence = 0.0);

struct SpectralPeak {
  double frequency = 0;   // [Hz] vertex of the parabola through the three highest samples
  double density = 0;     // [unit^2/Hz] at the vertex
  double prominence = 0;  // [unit^2/Hz]
  double width = 0;       // [Hz] at half prominence
};

// Peaks of a spectrum between two frequencies [Hz], the most prominent first, those only that have at least `share` of
// the prominence of the first.
std::vector<SpectralPeak> spectralPeaks(const PowerSpectrum& spectrum, double low, double high, double share = 0.02);

}  // namespace squat::signals
