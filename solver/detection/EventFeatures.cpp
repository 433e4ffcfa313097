#include "detection/EventFeatures.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "detection/LocalLevel.h"

namespace squat::detection {
namespace {

constexpr double neighbourhood = 3.0;  // [m]
constexpr double loudShare = 0.1;
constexpr std::size_t firstShortWaves = 2;  // bands from 320 Hz: what a short defect excites

std::size_t cellAt(const std::vector<double>& travelled, double position) {
  const auto found = std::lower_bound(travelled.begin(), travelled.end(), position);
  return std::min(static_cast<std::size_t>(found - travelled.begin()), travelled.size() - 1);
}

// Power above the level in the bands of short waves.
double loudness(const BandPower& power, const Evidence& evidence, std::size_t cell) {
  double sum = 0;
  for (std::size_t b = firstShortWaves; b < power.power.size(); ++b)
    sum += std::max(0.0, power.power[b][cell] - evidence.level[b][cell]);
  return sum;
}

double meanLoudness(const BandPower& power, const Evidence& evidence, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += loudness(power, evidence, i);
  return to > from ? sum / static_cast<double>(to - from) : 0;
}

// Level of the same bands over some cells.
double meanLevel(const Evidence& evidence, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t b = firstShortWaves; b < evidence.level.size(); ++b)
    for (std::size_t i = from; i < to; ++i) sum += evidence.level[b][i];
  return to > from ? sum / static_cast<double>(to - from) : 0;
}

// Length of the stretch around the event in quarter metres that are at least a tenth as loud as the event's own, and as
// loud again as their surroundings; it ends where two in a row are not. Squats that follow each other are not one
// stretch.
double reachOf(const BandPower& power, const Evidence& evidence, const std::vector<double>& travelled,
               std::size_t anchor) {
  constexpr double piece = 0.25;
  const double here = travelled[anchor];
  double own = 0;
  std::vector<double> pieces;
  std::size_t centre = 0;
  for (double from = here - neighbourhood; from < here + neighbourhood - 0.5 * piece; from += piece) {
    if (from + piece < travelled.front() || from > travelled.back()) continue;
    const auto first = cellAt(travelled, from), end = cellAt(travelled, from + piece);
    const double loud = meanLoudness(power, evidence, first, end);
    pieces.push_back(loud > meanLevel(evidence, first, end) ? loud : 0.0);
    if (std::abs(from + 0.5 * piece - here) > piece || pieces.back() <= own) continue;
    own = pieces.back(), centre = pieces.size() - 1;
  }
  if (!(own > 0)) return 0;
  const auto isLoud = [&](double p) { return p >= loudShare * own; };
  const auto loudFrom = [&](auto from, auto end) {
    std::ptrdiff_t loud = 0;
    for (int quiet = 0; from != end && quiet < 2; ++from) quiet = isLoud(*from) ? 0 : quiet + 1, loud += isLoud(*from);
    return loud;
  };
  const auto middle = pieces.begin() + static_cast<std::ptrdiff_t>(centre);
  const auto loud = loudFrom(middle, pieces.end()) + loudFrom(std::make_reverse_iterator(middle), pieces.rend());
  return piece * static_cast<double>(loud);
}

double meanFrequency(const BandPower& power, const Evidence& evidence, std::size_t from, std::size_t to) {
  double sum = 0, weighted = 0;
  for (std::size_t b = 3; b < power.power.size(); ++b) {
    const auto& band = detectionBands()[b];
    double energy = 0;
    for (std::size_t i = from; i < to; ++i) energy += std::max(0.0, power.power[b][i] - evidence.level[b][i]);
    sum += energy, weighted += energy * std::sqrt(band.low * band.high);
  }
  return sum > 0 ? weighted / sum : 0;
}

}  // namespace

EventFeatures eventFeatures(const BandPower& power, const Evidence& evidence, double rate,
                            const std::vector<double>& speed, const std::vector<double>& travelled,
                            std::size_t anchor) {
  EventFeatures features;
  features.speed = speed[anchor];
  const double here = travelled[anchor];
  for (std::size_t b = 0; b < bandCount; ++b) {
    if (!shows(rate, detectionBands()[b])) continue;
    const auto window = eventWindow(b);
    const auto first = cellAt(travelled, here - window.before), end = cellAt(travelled, here + window.behind);
    for (std::size_t i = first; i < end; ++i) {
      features.energy[b] += power.step * power.power[b][i];
      features.noise[b] += power.step * evidence.level[b][i];
    }
    features.freedom[b] = degreesOfFreedom(detectionBands()[b], power.step * static_cast<double>(end - first));
  }
  const auto window = eventWindow(bandCount - 1);
  const auto from = cellAt(travelled, here - window.before), to = cellAt(travelled, here + window.behind);
  const double inside = meanLoudness(power, evidence, from, to);
  const double ahead = meanLoudness(power, evidence, cellAt(travelled, here - 1.5), cellAt(travelled, here - 0.3));
  features.before = inside > 0 ? ahead / inside : 0;
  features.reach = reachOf(power, evidence, travelled, anchor);
  const double frequency = meanFrequency(power, evidence, from, to);
  features.wavelength = frequency > 0 ? features.speed / frequency : 0;
  return features;
}

}  // namespace squat::detection
