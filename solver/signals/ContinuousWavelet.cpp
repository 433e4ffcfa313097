#include "signals/ContinuousWavelet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "signals/PowerSpectrum.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

// Frequency times scale at the strongest answer.
double toneFactor(WaveletNormalisation normalisation) {
  if (normalisation == WaveletNormalisation::amplitude) return morletFrequency / (2 * std::numbers::pi);
  return (morletFrequency + std::sqrt(2 + morletFrequency * morletFrequency)) / (4 * std::numbers::pi);
}

// The frequencies asked for, refused where the upper end is above half the rate even if no voice falls there.
std::vector<double> frequenciesFor(const TimeSeries& series, const WaveletOptions& options) {
  if (options.highest > series.rate() / 2 * (1 + 1e-12)) {
    std::ostringstream text;
    text << "a wavelet transform up to " << options.highest << " Hz needs a sampling rate of at least "
         << 2 * options.highest << " Hz; this one is " << series.rate() << " Hz";
    throw SignalError(text.str());
  }
  return waveletFrequencies(options.lowest, options.highest, options.voicesPerOctave);
}

std::size_t strideWithin(std::size_t cell) {
  // Four values of |W|^2 a cell keep the mean smooth.
  std::size_t stride = 1;
  while (cell % (stride * 2) == 0 && stride * 8 <= cell) stride *= 2;
  return stride;
}

// What the wavelets of the shown part see of the record: 7 scales, where exp(-t^2/2) is 2e-11. A long record is not
// transformed as a whole for a glance at it.
TimeSeries seenPart(const TimeSeries& series, const WaveletOptions& options) {
  if (!options.shown) return series;
  const double margin = 7 * waveletScale(options.lowest, options.normalisation);
  return cutOut(series, options.shown->first - margin, options.shown->second + margin);
}

// First sample with a column, and the one behind the last.
std::pair<std::size_t, std::size_t> shownSamples(const TimeSeries& series, const WaveletOptions& options) {
  const std::size_t n = series.values.size();
  if (!options.shown) return {0, n};
  const auto [from, to] = *options.shown;
  const double size = static_cast<double>(n);
  const double first = std::clamp(std::ceil((from - series.start) / series.step - 1e-6), 0.0, size);
  const double last = std::clamp(std::floor((to - series.start) / series.step + 1e-6) + 1, 0.0, size);
  if (!(last > first)) throw SignalError("a scalogram needs at least one sample in the part that is shown");
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

}  // namespace

double waveletScale(double frequency, WaveletNormalisation normalisation) {
  return toneFactor(normalisation) / frequency;
}

std::vector<double> waveletFrequencies(double lowest, double highest, double voicesPerOctave) {
  if (!(lowest > 0 && highest >= lowest && std::isfinite(highest) && voicesPerOctave >= 1 && voicesPerOctave <= 256)) {
    std::ostringstream text;
    text << "a wavelet transform from " << lowest << " to " << highest << " Hz with " << voicesPerOctave
         << " voices per octave is not possible: frequencies must be positive and rise, voices be 1 to 256";
    throw SignalError(text.str());
  }
  const auto last = static_cast<std::size_t>(std::floor(std::log2(highest / lowest) * voicesPerOctave + 1e-9));
  std::vector<double> frequencies(last + 1);
  for (std::size_t i = 0; i <= last; ++i) frequencies[i] = lowest * std::exp2(static_cast<double>(i) / voicesPerOctave);
  return frequencies;
}

std::vector<double> coneOfInfluence(const std::vector<double>& time, double recordStart, double recordEnd, double rate,
                                    WaveletNormalisation normalisation) {
  std::vector<double> lowest(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double distance = std::min(time[i] - recordStart, recordEnd - time[i]);
    const double scale = std::max(distance, 0.0) / std::numbers::sqrt2;
    lowest[i] = std::min(rate / 2, scale > 0 ? toneFactor(normalisation) / scale : rate / 2);
  }
  return lowest;
}

Scalogram scalogram(const TimeSeries& series, const WaveletOptions& options) {
  requireUsable(series, 2, "a scalogram");
  requireVarying(series, "a scalogram");
  Scalogram result;
  result.frequency = frequenciesFor(series, options);
  const TimeSeries seen = seenPart(series, options);
  const auto shown = shownSamples(seen, options);
  const auto begin = shown.first, end = shown.second;  // plain: in clang 14 no lambda captures a binding
  const std::size_t n = end - begin;
  const std::size_t cell = std::clamp<std::size_t>(options.cell, 1, n);
  const std::size_t columns = (n + cell - 1) / cell;
  result.time.resize(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const double width = static_cast<double>(std::min(cell, n - c * cell));
    result.time[c] = seen.timeAt(begin) + series.step * (static_cast<double>(c * cell) + 0.5 * (width - 1));
  }
  result.power.assign(result.frequency.size() * columns, 0.0);
  std::vector<std::uint32_t> counts(result.power.size(), 0);
  transformInBlocks(seen, result.frequency, options.normalisation, strideWithin(cell), options.threads,
                    [&](const WaveletPart& part) {
                      for (std::size_t i = 0; i < part.coefficients.size(); ++i) {
                        const std::size_t sample = part.first + i * part.stride;
                        if (sample < begin || sample >= end) continue;
                        const std::size_t column = (sample - begin) / cell;
                        result.power[part.voice * columns + column] += std::norm(part.coefficients[i]);
                        ++counts[part.voice * columns + column];
                      }
                    });
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 1) result.power[i] /= counts[i];
  result.coneOfInfluence = coneOfInfluence(result.time, series.start, series.timeAt(series.values.size() - 1),
                                           series.rate(), options.normalisation);
  result.normalisation = options.normalisation == WaveletNormalisation::energy
                             ? "Morlet w0 = 6, power |W|^2 of W = s^(-1/2) Int x psi* dt"
                             : "Morlet w0 = 6, amplitude-normalised: a unit tone gives 1";
  return result;
}

std::vector<std::complex<double>> waveletCoefficients(const TimeSeries& series, double frequency,
                                                      WaveletNormalisation normalisation) {
  requireUsable(series, 2, "a wavelet transform");
  std::vector<std::complex<double>> result(series.values.size());
  transformInBlocks(series, {frequency}, normalisation, 1, 1, [&](const WaveletPart& part) {
    std::copy(part.coefficients.begin(), part.coefficients.end(),
              result.begin() + static_cast<std::ptrdiff_t>(part.first));
  });
  return result;
}

std::vector<double> meanWaveletPower(const TimeSeries& series, const WaveletOptions& options) {
  requireUsable(series, 2, "a wavelet spectrum");
  const auto frequencies = frequenciesFor(series, options);
  std::vector<double> sums(frequencies.size(), 0.0), counts(frequencies.size(), 0.0);
  transformInBlocks(series, frequencies, options.normalisation, std::numeric_limits<std::size_t>::max(),
                    options.threads, [&](const WaveletPart& part) {
                      for (const auto& coefficient : part.coefficients) sums[part.voice] += std::norm(coefficient);
                      counts[part.voice] += static_cast<double>(part.coefficients.size());
                    });
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= std::max(1.0, counts[v]);
  return sums;
}

}  // namespace squat::signals
