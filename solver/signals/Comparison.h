// solver/signals/Comparison.h - two signals of one place: computed beside measured, or a defect beside smooth track.
#pragma once

#include <string>
#include <vector>

#include "signals/Alignment.h"
#include "signals/Features.h"

namespace squat::signals {

struct ComparisonOptions {
  FeatureOptions
      features;       // bands, spectrum window, wave band; speed (and anchor, where none is given) from the passages
  bool align = true;  // false: the axes already agree (a defect and the same track's smooth run)
  bool inPosition = false;   // align over position instead of time
  double largestShift = 0;   // [s] or [m]; 0: any
  double peakSearch = 0.15;  // peaks belong together within this share of their frequency
};

struct PeakPair {
  double first = 0, second = 0;  // [Hz]
  double shift() const { return first - second; }
};

struct Comparison {
  std::string firstName, secondName, unit;
  bool inPosition = false;
  std::vector<double> axis;                       // [s] or [m], zero at the first signal's anchor
  std::vector<double> first, second, difference;  // difference: first - second
  PowerSpectrum firstSpectrum, secondSpectrum;    // around the anchor, on the same frequencies
  std::vector<double> densityRatio;               // first / second; 0 where the second vanishes, NaN
                                                  // beyond half the lower sampling rate
  Features firstFeatures, secondFeatures;
  double shift = 0;        // of the second's own axis against the first's: anchor of second - anchor of first
  double correlation = 0;  // over the window of the spectrum
  double peakRatio = 0;    // of the largest absolute values around the anchor, first / second
  double rmsRatio = 0;
  double differencePeak = 0, differenceRms = 0;  // [unit] of first - second
  std::vector<Band> bands;
  std::vector<double> bandRatio;  // first / second; NaN where the slower record cannot hold the band
  std::vector<PeakPair> peaks;    // lines of both spectra, in order of the first's prominence
};

// Signals of different rates are put on the first's. Throws SignalError like alignment and features.
Comparison compare(const Passage& first, const Passage& second, const ComparisonOptions& options = {});

// The table of a comparison: names with unit and values, in a fixed order.
std::vector<std::pair<std::string, double>> comparisonRow(const Comparison& comparison);

}  // namespace squat::signals
