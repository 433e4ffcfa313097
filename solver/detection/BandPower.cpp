#include "detection/BandPower.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "signals/ContinuousWavelet.h"

namespace squat::detection {
namespace {

constexpr double voicesPerOctave = 6;
constexpr double cellSeconds = 1e-3;

struct Voices {
  std::vector<double> frequency;
  std::vector<std::size_t> band;  // of each voice
  std::vector<double> weight;     // of its power in the band
};

// A voice at f answers white noise of density S with 2 S f sqrt(pi) / w0 (the integral of its squared gain, amplitude
// normalised); half of it, over its share of the band, gives back S df.
Voices voicesFor(double rate) {
  Voices voices;
  const auto& bands = detectionBands();
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (!shows(rate, bands[b])) continue;
    const double octaves = std::log2(bands[b].high / bands[b].low);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(voicesPerOctave * octaves)));
    const double width = octaves / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      voices.frequency.push_back(bands[b].low * std::exp2(width * (static_cast<double>(i) + 0.5)));
      voices.band.push_back(b);
      voices.weight.push_back(0.5 * width * std::numbers::ln2 * signals::morletFrequency / std::sqrt(std::numbers::pi));
    }
  }
  return voices;
}

}  // namespace

const std::vector<DetectionBand>& detectionBands() {
  static const std::vector<DetectionBand> bands{{"40-130 Hz", 40, 130},     {"130-320 Hz", 130, 320},
                                                {"320-560 Hz", 320, 560},   {"560-900 Hz", 560, 900},
                                                {"900-1250 Hz", 900, 1250}, {"1250-2000 Hz", 1250, 2000}};
  return bands;
}

bool shows(double rate, const DetectionBand& band) { return band.high <= 0.45 * rate; }

double degreesOfFreedom(const DetectionBand& band, double duration) {
  return std::max(1.0, 2 * (band.high - band.low) * duration);
}

BandPower bandPower(const signals::TimeSeries& series) {
  const auto samples = series.values.size();
  BandPower result;
  result.cell = std::bit_floor(std::max<std::size_t>(1, static_cast<std::size_t>(cellSeconds * series.rate())));
  result.step = series.step * static_cast<double>(result.cell);
  result.start = series.start + 0.5 * series.step * static_cast<double>(result.cell - 1);
  const auto cells = (samples + result.cell - 1) / result.cell;
  result.power.assign(detectionBands().size(), std::vector<double>(cells, 0.0));
  const auto voices = voicesFor(series.rate());
  if (voices.frequency.empty()) return result;
  signals::transformInBlocks(series, voices.frequency, signals::WaveletNormalisation::amplitude, result.cell, 1,
                             [&](const signals::WaveletPart& part) {
                               auto& row = result.power[voices.band[part.voice]];
                               const double share = voices.weight[part.voice] * static_cast<double>(part.stride) /
                                                    static_cast<double>(result.cell);
                               for (std::size_t i = 0; i < part.coefficients.size(); ++i)
                                 row[(part.first + i * part.stride) / result.cell] +=
                                     share * std::norm(part.coefficients[i]);
                             });
  return result;
}

}  // namespace squat::detection
