#include "signals/Window.h"

#include <array>
#include <cmath>
#include <numbers>

#include "signals/SignalError.h"

namespace squat::signals {
namespace {

const std::array<const char*, 4> windowNames{"boxcar", "hann", "hamming", "blackman"};
const std::array<const char*, 3> detrendNames{"none", "constant", "linear"};

template <class Enum, std::size_t N>
Enum fromText(const std::string& text, const std::array<const char*, N>& names, const char* what) {
  std::string known;
  for (std::size_t i = 0; i < N; ++i) {
    if (text == names[i]) return static_cast<Enum>(i);
    known += (i ? ", " : "") + std::string(names[i]);
  }
  throw SignalError("unknown " + std::string(what) + " '" + text + "'; known are " + known);
}

}  // namespace

std::vector<double> windowWeights(Window window, std::size_t n) {
  double a0 = 1, a1 = 0, a2 = 0;
  if (window == Window::hann) a0 = 0.5, a1 = 0.5;
  if (window == Window::hamming) a0 = 0.54, a1 = 0.46;
  if (window == Window::blackman) a0 = 0.42, a1 = 0.5, a2 = 0.08;
  std::vector<double> weights(n, 1.0);
  if (n < 2) return weights;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    weights[i] = a0 - a1 * std::cos(angle) + a2 * std::cos(2 * angle);
  }
  return weights;
}

std::string toText(Window window) { return windowNames[static_cast<std::size_t>(window)]; }
Window windowFromText(const std::string& text) { return fromText<Window>(text, windowNames, "window"); }

void removeTrend(double* values, std::size_t n, Detrend detrend) {
  if (detrend == Detrend::none || n == 0) return;
  double mean = 0;
  for (std::size_t i = 0; i < n; ++i) mean += values[i];
  mean /= static_cast<double>(n);
  double slope = 0;
  const double middle = 0.5 * static_cast<double>(n - 1);
  if (detrend == Detrend::linear && n > 1) {
    double moment = 0, square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double offset = static_cast<double>(i) - middle;
      moment += offset * (values[i] - mean);
      square += offset * offset;
    }
    slope = moment / square;
  }
  for (std::size_t i = 0; i < n; ++i) values[i] -= mean + slope * (static_cast<double>(i) - middle);
}

std::string toText(Detrend detrend) { return detrendNames[static_cast<std::size_t>(detrend)]; }
Detrend detrendFromText(const std::string& text) { return fromText<Detrend>(text, detrendNames, "detrend"); }

}  // namespace squat::signals
