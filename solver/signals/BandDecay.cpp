#include "signals/BandDecay.h"

#include <algorithm>
#include <cmath>

#include "signals/Butterworth.h"
#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

struct Fall {
  std::size_t length = 0;  // samples from the top to the last one at or above the level
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
    if (below >= quiet) return {end - top, true};
  }
  return {end - top, false};
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

}  // namespace

std::vector<double> envelope(const TimeSeries& series) {
  const std::size_t n = series.values.size();
  std::vector<Complex> values(fastLength(2 * n));  // zeros behind: the end does not reach round to the beginning
  std::copy(series.values.begin(), series.values.end(), values.begin());
  ComplexTransform(values.size(), Direction::forward).inPlace(values.data());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool unpaired = k == 0 || 2 * k == values.size();
    values[k] *= (unpaired ? 1.0 : 2 * k < values.size() ? 2.0 : 0.0) / static_cast<double>(values.size());
  }
  ComplexTransform(values.size(), Direction::backward).inPlace(values.data());
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = std::abs(values[i]);
  return result;
}

BandDecay bandDecay(const TimeSeries& series, double from, double to, const Band& band, double level) {
  if (!(level > 0 && level < 1)) throw SignalError("the level of a decay must lie between 0 and 1");
  const TimeSeries part = cutOut(series, from, to);
  const auto first = static_cast<std::size_t>(std::llround((part.start - series.start) / series.step));
  const auto values = envelope(bandPass(series, band.low, band.high));
  const std::size_t own = ownFall(series.step, band, level);
  const auto fall = fallOf(values, first, first + part.values.size() - 1, level, std::max<std::size_t>(1, own / 2));
  return {static_cast<double>(fall.length) * series.step, static_cast<double>(own) * series.step, fall.ended};
}

}  // namespace squat::signals
