// solver/signals/Window.h - tapers for spectra. Periodic ("DFT-even") forms, as SciPy's get_window gives them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::signals {

enum class Window { boxcar, hann, hamming, blackman };

// n weights, the largest is 1 (for n even). Sums of cosines a0 - a1 cos(2 pi i/n) + a2 cos(4 pi i/n).
std::vector<double> windowWeights(Window window, std::size_t n);

std::string toText(Window window);
// "boxcar", "hann", "hamming" or "blackman"; throws SignalError for another word.
Window windowFromText(const std::string& text);

enum class Detrend { none, constant, linear };

// Takes the mean or the least-squares line off the n values, in place.
void removeTrend(double* values, std::size_t n, Detrend detrend);

std::string toText(Detrend detrend);
Detrend detrendFromText(const std::string& text);

}  // namespace squat::signals
