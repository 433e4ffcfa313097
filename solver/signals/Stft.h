// solver/signals/Stft.h - short-time Fourier transform: local spectra under a sliding window.
#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "signals/TimeSeries.h"
#include "signals/Window.h"

namespace squat::signals {

struct StftOptions {
  Window window = Window::hann;
  std::size_t segment = 256;        // samples under the window
  std::size_t hop = 32;             // samples from one window to the next
  std::size_t transformLength = 0;  // zeros appended; 0: the segment's length
};

// S[k, j] = sum_i w[i] x[j hop + i] exp(-2 pi i k/n) / sum w: a tone of amplitude a gives |S| = a/2 at its frequency.
// SciPy's stft(detrend=False, boundary=None, padded=False). Only whole windows.
struct Stft {
  std::vector<double> frequency;                   // [Hz]
  std::vector<double> time;                        // [s] middle of each window
  std::vector<std::complex<double>> coefficients;  // row by row, one row a frequency
  std::vector<double> density;  // the same layout: one-sided power density [unit^2/Hz] of each window
  std::string window;           // in words
  std::size_t segment = 0;      // samples under the window

  std::size_t index(std::size_t row, std::size_t column) const { return row * time.size() + column; }
};

// Throws SignalError for a signal that is shorter than the segment or not finite, and for a hop of zero.
Stft shortTimeTransform(const TimeSeries& series, const StftOptions& options = {});

}  // namespace squat::signals
