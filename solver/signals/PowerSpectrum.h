// solver/signals/PowerSpectrum.h - one-sided power spectral densities: periodogram and Welch's average of segments.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "signals/TimeSeries.h"
#include "signals/Window.h"

namespace squat::signals {

struct PowerSpectrumOptions {
  Window window = Window::hann;
  Detrend detrend = Detrend::constant;  // of each segment
  std::size_t segment = 0;              // samples; 0: the whole record, which makes a periodogram
  double overlap = 0.5;                 // share of a segment, 0 <= overlap < 1; without meaning for a single segment
  std::size_t transformLength = 0;      // samples, zeros appended for a finer frequency grid; 0: the segment's length
};

// Density G(f) with sum(G) df = mean square: G[k] = 2 |sum_i w[i] x[i] exp(-2 pi i k/n)|^2 / (rate sum w^2), without
// the 2 at zero and at half the rate. SciPy's welch(scaling="density", average="mean") for the same options.
struct PowerSpectrum {
  std::vector<double> frequency;  // [Hz] from 0, equally spaced
  std::vector<double> density;    // [unit^2/Hz]
  std::string unit;               // of the signal
  std::string window;             // in words: window, segment length, overlap, detrend
  std::size_t segmentLength = 0, segments = 0;
  double integral = 0;    // [unit^2] sum of density times frequency step
  double meanSquare = 0;  // [unit^2] of the detrended segments before windowing: what the integral should be

  double step() const { return frequency.size() > 1 ? frequency[1] - frequency[0] : 0.0; }
};

// Throws SignalError for a signal that is too short for the segment, constant, or not finite.
PowerSpectrum powerSpectrum(const TimeSeries& series, const PowerSpectrumOptions& options = {});

// Integral of the density over low <= f <= high [unit^2], the density taken as linear between its samples. Throws
// SignalError where the band reaches above half the sampling rate.
double bandPower(const PowerSpectrum& spectrum, double low, double high);

// The samples with from <= time <= to. Throws SignalError where there is none.
TimeSeries cutOut(const TimeSeries& series, double from, double to);

}  // namespace squat::signals
