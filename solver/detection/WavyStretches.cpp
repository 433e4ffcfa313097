#include "detection/WavyStretches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "signals/FourierTransform.h"
#include "signals/Median.h"

namespace squat::detection {
namespace {

constexpr double pieceOfWay = 8, windowOfWay = 4, windowsOver = 16;  // [m]
constexpr double shortestWave = 0.02, longestWave = 0.4;             // [m]
constexpr double lowestFrequency = 30;                               // [Hz] below, vehicles sway
constexpr double nearby = 1.15;                                      // ratio of wavelengths that are one
// Of the power at one wavelength. On 20 s of measured corrugated track, 0.39 to 0.84 in each second; on ordinary track
// 0.12 to 0.44 in 38 of 40 channels' seconds.
constexpr double leastShare = 0.45;
// By how much the wavelength's power in each hertz exceeds that of either side, up to 1.6 times as far: 1.6 to 15 on
// the corrugated track. Rough rails without waves have broad swells of 2 dB, 1.6.
constexpr double leastProminence = 1.5, leastMeanProminence = 2, aside = 1.6;  // of a piece, of a stretch
constexpr double shortestStretch = 16;                                         // [m]
constexpr double leastSteadiness = 0.1;
// Between these the rail vibrates between its sleepers (pinned-pinned) wherever it lies: a peak there is corrugation
// only where it holds nearly all.
constexpr double pinnedFrom = 850, pinnedTo = 1300, leastPinnedShare = 0.75;  // [Hz]

// Median over windows of the power in each line of the spectrum: impacts, which are in few of them, do not count.
std::vector<double> medianSpectrum(const std::vector<double>& values, std::size_t from, std::size_t to,
                                   std::size_t length, const signals::RealTransform& transform) {
  std::vector<double> window(length), piece(length);
  for (std::size_t i = 0; i < length; ++i)
    window[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
  std::vector<std::vector<double>> lines(length / 2 + 1);
  std::vector<signals::Complex> spectrum(length / 2 + 1);
  for (std::size_t first = from; first + length <= to; first += length / 2) {
    for (std::size_t i = 0; i < length; ++i) piece[i] = window[i] * values[first + i];
    transform.forward(piece.data(), spectrum.data());
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k].push_back(std::norm(spectrum[k]));
  }
  std::vector<double> medians;
  for (auto& line : lines) medians.push_back(line.empty() ? 0 : signals::median(std::move(line)));
  return medians;
}

struct Peak {
  double frequency = 0, share = 0, prominence = 0;
};

Peak peakOf(const std::vector<double>& power, double lineWidth, double speed) {
  const auto lineAt = [&](double frequency) {
    return std::min(power.size(), static_cast<std::size_t>(std::ceil(frequency / lineWidth)));
  };
  const auto sum = [&](double low, double high) {
    double total = 0;
    for (std::size_t k = lineAt(low); k < lineAt(high); ++k) total += power[k];
    return total;
  };
  const auto density = [&](double low, double high) {
    return sum(low, high) / std::max(1.0, static_cast<double>(lineAt(high) - lineAt(low)));
  };
  const double highest = lineWidth * static_cast<double>(power.size());
  const auto first = lineAt(std::max(lowestFrequency, speed / longestWave)), end = lineAt(speed / shortestWave);
  if (first >= end) return {};
  const auto at = std::max_element(power.begin() + static_cast<std::ptrdiff_t>(first),
                                   power.begin() + static_cast<std::ptrdiff_t>(end));
  const double frequency = lineWidth * static_cast<double>(at - power.begin());
  const double all = sum(lowestFrequency, highest);
  if (!(all > 0)) return {};
  const double around = density(frequency / nearby, frequency * nearby);
  const double sides =
      std::max(density(frequency / aside, frequency / nearby), density(frequency * nearby, frequency * aside));
  return {frequency, sum(frequency / nearby, frequency * nearby) / all, sides > 0 ? around / sides : 1e9};
}

// The value that the power of a frequency's band exceeds three quarters of the way, by its mean: some 0.3 for noise,
// near nothing for impacts.
double steadiness(const BandPower& power, double frequency, double from, double to) {
  const auto& bands = detectionBands();
  std::size_t band = 0;
  while (band + 1 < bands.size() && frequency > bands[band].high) ++band;
  std::vector<double> values;
  double sum = 0;
  for (std::size_t i = 0; i < power.cells(); ++i)
    if (power.timeAt(i) >= from && power.timeAt(i) < to) values.push_back(power.power[band][i]), sum += values.back();
  if (!(sum > 0)) return 0;
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quarter, values.end());
  return *quarter / (sum / static_cast<double>(values.size()));
}

bool isSameWave(double one, double other) { return std::max(one, other) < nearby * std::min(one, other); }

}  // namespace

std::vector<WavyStretch> wavyStretches(const Segment& segment, std::size_t channel, const BandPower& bandPower) {
  const auto& series = segment.channels[channel];
  std::vector<WavyStretch> pieces;
  std::optional<signals::RealTransform> transform;
  std::size_t i = 0;
  while (i < series.values.size() && series.timeAt(i) < segment.coreStart) ++i;
  while (i < series.values.size() && series.timeAt(i) < segment.coreEnd) {
    const std::size_t first = i;
    double way = 0;
    for (; i < series.values.size() && way < pieceOfWay && series.timeAt(i) < segment.coreEnd; ++i)
      way += std::max(0.0, segment.speed[i]) * series.step;
    const double speed = segment.speed[(first + i) / 2];
    if (speed < minimumSpeed || way < 0.5 * pieceOfWay) continue;
    const auto wished = static_cast<std::size_t>(windowOfWay / speed / series.step);
    if (wished < 64) continue;  // a speed that no train has
    if (!transform || transform->size() < wished || transform->size() > wished + wished / 8)
      transform.emplace(signals::fastLength(wished));
    const auto half = static_cast<std::size_t>(0.5 * windowsOver / speed / series.step);
    const std::size_t centre = (first + i) / 2, from = centre > half ? centre - half : 0;
    const auto power = medianSpectrum(series.values, from, std::min(series.values.size(), centre + half),
                                      transform->size(), *transform);
    const auto peak = peakOf(power, series.rate() / static_cast<double>(transform->size()), speed);
    const bool isPinned = peak.frequency > pinnedFrom && peak.frequency < pinnedTo;
    if (peak.share >= (isPinned ? leastPinnedShare : leastShare) && peak.prominence >= leastProminence &&
        steadiness(bandPower, peak.frequency, series.timeAt(from), series.timeAt(from + 2 * half)) >= leastSteadiness) {
      const double wave = speed / peak.frequency;
      pieces.push_back({series.timeAt(first), segment.position[first], segment.position[i - 1], wave, wave, wave,
                        peak.share, speed, speed, peak.prominence});
    }
  }
  return pieces;
}

std::vector<WavyStretch> joined(const std::vector<WavyStretch>& pieces) {
  std::vector<WavyStretch> stretches;
  for (const auto& piece : pieces) {
    const bool follows = !stretches.empty() && std::abs(piece.from - stretches.back().to) < 1.5 * pieceOfWay &&
                         isSameWave(piece.wavelength, stretches.back().shortest) &&
                         isSameWave(piece.wavelength, stretches.back().longest);
    if (!follows) {
      stretches.push_back(piece);
      continue;
    }
    auto& last = stretches.back();
    const double before = std::abs(last.to - last.from), added = std::abs(piece.to - piece.from);
    const double weight = added / std::max(before + added, 1e-9);
    last.wavelength += weight * (piece.wavelength - last.wavelength);
    last.share += weight * (piece.share - last.share);
    last.prominence += weight * (piece.prominence - last.prominence);
    last.shortest = std::min(last.shortest, piece.wavelength), last.longest = std::max(last.longest, piece.wavelength);
    last.slowest = std::min(last.slowest, piece.slowest), last.fastest = std::max(last.fastest, piece.fastest);
    last.to = piece.to;
  }
  std::erase_if(stretches, [](const WavyStretch& each) {
    return std::abs(each.to - each.from) < 0.9 * shortestStretch || each.prominence < leastMeanProminence;
  });
  return stretches;
}

}  // namespace squat::detection
