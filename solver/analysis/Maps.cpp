#include "analysis/Maps.h"

#include <algorithm>
#include <cmath>

#include "signals/FourierTransform.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::analysis {
namespace {

constexpr std::size_t maximumColumns = 2000, maximumRows = 1000;  // of a picture
constexpr double slowestWave = 1e-5;  // of the sampling rate: longer wavelets outgrow the memory

// Below one wave in the record a row shows nothing but its ends.
void raiseLowest(const signals::TimeSeries& series, double& lowest, std::vector<std::string>& notes) {
  const double seconds = static_cast<double>(series.values.size()) * series.step;
  const double longest = std::max(1 / seconds, slowestWave * series.rate());
  if (!(lowest < longest)) return;
  lowest = longest;
  notes.push_back("the scalogram starts at " + text::formatted("%g Hz", longest) +
                  (longest * seconds > 1.5 ? ", 1e-5 of the sampling rate" : ", one period in the record"));
}

// More rows than a picture can show take memory and time alone.
void limitVoices(signals::WaveletOptions& options, std::vector<std::string>& notes) {
  const double octaves = std::log2(options.highest / options.lowest);
  if (!(options.voicesPerOctave * octaves > maximumRows)) return;
  options.voicesPerOctave = std::max(1.0, std::floor(maximumRows / octaves));
  notes.push_back("the scalogram has " + std::to_string(std::lround(options.voicesPerOctave)) +
                  " voices per octave, limited to " + std::to_string(maximumRows) + " rows");
}

}  // namespace

std::optional<signals::Stft> stftMap(const signals::TimeSeries& series, signals::StftOptions options,
                                     std::vector<std::string>& notes) {
  const std::size_t n = series.values.size();
  if (options.segment == 0) {
    options.segment = signals::fastLength(static_cast<std::size_t>(std::max(16.0, 0.01 * series.rate())));
    if (n < options.segment) {
      notes.push_back("no STFT: the record is shorter than its window of 10 ms");
      return std::nullopt;
    }
  }
  if (options.hop == 0) options.hop = std::max<std::size_t>(1, (n - std::min(n, options.segment)) / maximumColumns + 1);
  return signals::shortTimeTransform(series, options);
}

signals::Scalogram scalogramMap(const signals::TimeSeries& series, signals::WaveletOptions options,
                                std::vector<std::string>& notes) {
  const double half = series.rate() / 2;
  if (options.highest > half) {
    notes.push_back("the scalogram ends at " + text::formatted("%g Hz", half) + ", half the sampling rate");
    options.highest = half;
  }
  if (options.lowest >= options.highest) {
    options.lowest = options.highest / 8;
    notes.push_back("the scalogram starts at " + text::formatted("%g Hz", options.lowest) +
                    ", three octaves below its end");
  }
  raiseLowest(series, options.lowest, notes);
  if (options.lowest >= options.highest)
    throw signals::SignalError("the scalogram of a record of this length and rate starts at " +
                               text::formatted("%g Hz", options.lowest) + ", above its highest frequency of " +
                               text::formatted("%g Hz", options.highest) + "; raise the highest frequency");
  limitVoices(options, notes);
  const double length = static_cast<double>(series.values.size()) * series.step;
  const double samples = (options.shown ? options.shown->second - options.shown->first : length) / series.step;
  if (options.cell == 0) options.cell = static_cast<std::size_t>(samples) / maximumColumns + 1;
  return signals::scalogram(series, options);
}

}  // namespace squat::analysis
