#include "signals/BandDecay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "signals/Butterworth.h"
#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

struct Fall {
  std::size_t top = 0, length = 0;  // the largest value, samples from it to the last one at or above the level
  bool ended = true;
};

// From the largest value in first..last on, until `quiet` samples in a row lie below the level.
Fall fallOf(const std::vector<double>& values, std::size_t first, std::size_t last, double level, std::size_t quiet) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  const auto top = static_cast<std::size_t>(
      std::max_element(begin, values.begin() + static_cast<std::ptrdiff_t>(last + 1)) - values.begin());
  std::size_t end = top, below = 0;
  for (std::size_t i = top; i <= last; ++i) {
    below = values[i] >= level * values[top] ? 0 : below + 1;
    if (below == 0) end = i;
    if (below >= quiet) return {top, end - top, true};
  }
  return {top, end - top, false};
}

// The filter's answer to a kick in the middle of a record that is long enough for it to ring out.
std::size_t ownFall(double step, const Band& band, double level) {
  constexpr double periodsOfTheWidth = 40;
  const auto n = static_cast<std::size_t>(std::ceil(periodsOfTheWidth / ((band.high - band.low) * step)));
  TimeSeries kick{0, step, std::vector<double>(n, 0.0), "kick", "1"};
  kick.values[n / 2] = 1;
  const auto values = envelope(bandPass(kick, band.low, band.high));
  return std::max<std::size_t>(1, fallOf(values, n / 4, n - 1, level, n / 8).length);
}

// Mean of the phase's advance from sample to sample, weighed by power [Hz].
double meanFrequency(const std::vector<std::complex<double>>& signal, std::size_t first, std::size_t last,
                     double step) {
  std::complex<double> advance = 0;
  for (std::size_t i = first; i < last && i + 1 < signal.size(); ++i) advance += std::conj(signal[i]) * signal[i + 1];
  return std::arg(advance) / (2 * std::numbers::pi * step);
}

}  // namespace

std::vector<std::complex<double>> analyticSignal(const TimeSeries& series) {
  const std::size_t n = series.values.size();
  std::vector<Complex> values(fastLength(2 * n));  // zeros behind: the end does not reach round to the beginning
  std::copy(series.values.begin(), series.values.end(), values.begin());
  ComplexTransform(values.size(), Direction::forward).inPlace(values.data());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool unpaired = k == 0 || 2 * k == values.size();
    values[k] *= (unpaired ? 1.0 : 2 * k < values.size() ? 2.0 : 0.0) / static_cast<double>(values.size());
  }
  ComplexTransform(values.size(), Direction::backward).inPlace(values.data());
  values.resize(n);
  return {values.begin(), values.end()};
}

std::vector<double> envelope(const TimeSeries& series) {
  std::vector<double> result;
  for (const auto& value : analyticSignal(series)) result.push_back(std::abs(value));
  return result;
}

BandDecay bandDecay(const TimeSeries& series, double from, double to, const Band& band, double level) {
  if (!(level > 0 && level < 1)) throw SignalError("the level of a decay must lie between 0 and 1");
  const TimeSeries part = cutOut(series, from, to);
  const auto first = static_cast<std::size_t>(std::llround((part.start - series.start) / series.step));
  const auto signal = analyticSignal(bandPass(series, band.low, band.high));
  std::vector<double> values;
  for (const auto& value : signal) values.push_back(std::abs(value));
  const std::size_t own = ownFall(series.step, band, level);
  const std::size_t whole = signal.size() > own / 2 ? signal.size() - 1 - own / 2 : 0;
  const std::size_t last = std::max(first, std::min(first + part.values.size() - 1, whole));
  const auto fall = fallOf(values, first, last, level, std::max<std::size_t>(1, own / 2));
  const std::size_t end = fall.top + fall.length, ring = std::min(fall.top + own, end);
  return {static_cast<double>(fall.length) * series.step, static_cast<double>(own) * series.step, fall.ended,
          meanFrequency(signal, ring < end ? ring : fall.top, std::max(end, fall.top + 1), series.step)};
}

}  // namespace squat::signals
