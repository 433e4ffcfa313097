// Wavelength after the impact and duration of free vibration.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "signals/Butterworth.h"
#include "signals/ContinuousWavelet.h"
#include "signals/Features.h"
#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

constexpr double voicesPerOctave = 24;
constexpr double longestVibration = 1.0;  // [s] looked at after the impact

// Power of all voices of the band at every sample, row by row.
Scalogram bandScalogram(const TimeSeries& series, const Band& band) {
  WaveletOptions options;
  options.lowest = band.low;
  options.highest = band.high;
  options.voicesPerOctave = voicesPerOctave;
  options.normalisation = WaveletNormalisation::amplitude;
  return scalogram(series, options);
}

// The record a little around from..to: enough for the wavelets of the band not to see where it was cut. A map of very
// many samples would outgrow the memory: they are thinned out to forty a period of the band's highest wave.
TimeSeries surroundings(const TimeSeries& series, double from, double to, const Band& band) {
  constexpr std::size_t many = 1000000;
  const double margin = 7 * waveletScale(band.low, WaveletNormalisation::amplitude), fine = 1 / (40 * band.high);
  TimeSeries part = cutOut(series, from - margin, to + margin);
  return part.values.size() > many && part.step < fine ? resample(part, fine) : part;
}

}  // namespace

double wavelengthByCrossings(const TimeSeries& series, double from, double to, double speed, const Band& band) {
  const TimeSeries waves = cutOut(bandPass(series, band.low, band.high), from, to);
  std::size_t count = 0;
  double first = 0, last = 0;
  for (std::size_t i = 1; i < waves.values.size(); ++i) {
    const double before = waves.values[i - 1], now = waves.values[i];
    if ((before < 0) == (now < 0) || before == now) continue;
    const double time = waves.timeAt(i - 1) + waves.step * before / (before - now);
    if (count++ == 0) first = time;
    last = time;
  }
  if (count < 3) return std::numeric_limits<double>::quiet_NaN();
  return speed * 2 * (last - first) / static_cast<double>(count - 1);
}

double wavelengthByRidge(const TimeSeries& series, double from, double to, double speed, const Band& band) {
  const Scalogram map = bandScalogram(surroundings(series, from, to, band), band);
  double weightedFrequency = 0, weights = 0;
  const double rounding = 1e-6 * series.step;  // a limit that is a sample's own time but for rounding takes the sample
  for (std::size_t column = 0; column < map.time.size(); ++column) {
    if (map.time[column] < from - rounding || map.time[column] > to + rounding) continue;
    std::size_t best = 0;
    for (std::size_t row = 1; row < map.frequency.size(); ++row)
      if (map.at(row, column) > map.at(best, column)) best = row;
    double offset = 0;  // of the parabola's vertex, in voices
    if (best > 0 && best + 1 < map.frequency.size()) {
      const double below = map.at(best - 1, column), above = map.at(best + 1, column);
      const double bend = below - 2 * map.at(best, column) + above;
      if (bend < 0) offset = 0.5 * (below - above) / bend;
    }
    weightedFrequency += map.at(best, column) * map.frequency[best] * std::exp2(offset / voicesPerOctave);
    weights += map.at(best, column);
  }
  return weightedFrequency > 0 ? speed * weights / weightedFrequency : std::numeric_limits<double>::quiet_NaN();
}

FreeVibration freeVibration(const TimeSeries& series, double impact, const Band& band, double level) {
  if (impact > series.timeAt(series.values.size())) {
    std::ostringstream text;
    text << "the impact at " << impact << " s is after the end of the signal";
    throw SignalError(text.str());
  }
  const Scalogram map = bandScalogram(surroundings(series, impact, impact + longestVibration, band), band);
  std::vector<double> power(map.time.size(), 0.0);
  for (std::size_t row = 0; row < map.frequency.size(); ++row)
    for (std::size_t column = 0; column < power.size(); ++column) power[column] += map.at(row, column);
  const auto begin = std::lower_bound(map.time.begin(), map.time.end(), impact - 0.5 * series.step) - map.time.begin();
  if (begin == static_cast<std::ptrdiff_t>(power.size())) return {};
  const auto top = std::max_element(power.begin() + begin, power.end());
  const double limit = level * level * *top;
  const auto period = static_cast<std::size_t>(std::ceil(1 / (band.low * series.step)));
  std::size_t end = static_cast<std::size_t>(top - power.begin());
  std::size_t quiet = 0;
  for (std::size_t i = end; i < power.size() && quiet < period; ++i) {
    if (power[i] >= limit) {
      end = i;
      quiet = 0;
    } else {
      ++quiet;
    }
  }
  return {map.time[end] - impact, quiet >= period};
}

}  // namespace squat::signals
