#include "detection/Candidates.h"

#include <algorithm>
#include <cmath>

#include "detection/LocalLevel.h"
#include "signals/Median.h"

namespace squat::detection {
namespace {

constexpr double ringingSeconds = 8e-3;  // smoothing: about what an impact rings at 300 and 1000 Hz
constexpr double levelMetres = 15;       // half of the window of the local level
constexpr double anchorSeconds = 2e-3;   // smoothing where the impact is looked for
constexpr std::size_t firstSharp = 2;    // bands from 320 Hz: wavelets shorter than the way over a defect
constexpr double reached = 0.8;          // of the largest sum: the impact comes first, then its ringing
constexpr double anchorHalf = 12e-3;     // half of the time in which it is looked for

std::size_t cellsOf(double seconds, double step) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds / step)));
}

}  // namespace

Evidence evidenceOf(const BandPower& power, double rate, const std::vector<double>& speed,
                    const std::vector<bool>& silent) {
  const auto& bands = detectionBands();
  Evidence evidence;
  evidence.value.assign(power.cells(), 0.0);
  evidence.level.assign(bands.size(), std::vector<double>(power.cells(), 0.0));
  const std::size_t width = cellsOf(ringingSeconds, power.step);
  const double typicalSpeed = std::max(1.0, signals::median(speed));
  const std::size_t half = cellsOf(levelMetres / typicalSpeed, power.step);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (!shows(rate, bands[b])) continue;
    const double freedom = degreesOfFreedom(bands[b], static_cast<double>(width) * power.step);
    const auto row = smoothed(power.power[b], width);
    evidence.level[b] = localLevel(row, half, freedom, silent);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double ratio = evidence.level[b][i] > 0 ? row[i] / evidence.level[b][i] : 0;
      if (ratio > 1 && (silent.empty() || !silent[i]))
        evidence.value[i] += 0.5 * freedom * (ratio - 1 - std::log(ratio));
    }
  }
  return evidence;
}

std::size_t anchorIn(const BandPower& power, const std::vector<std::vector<double>>& level, std::size_t first,
                     std::size_t end) {
  std::vector<double> sum(end - first, 0.0);
  for (std::size_t b = firstSharp; b < power.power.size(); ++b) {
    const auto from = power.power[b].begin() + static_cast<std::ptrdiff_t>(first);
    const auto row =
        smoothed({from, from + static_cast<std::ptrdiff_t>(end - first)}, cellsOf(anchorSeconds, power.step));
    const double largest = *std::max_element(row.begin(), row.end());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double floor = std::max(level[b][first + i], largest / 30);
      if (floor > 0) sum[i] += std::log1p(row[i] / floor);
    }
  }
  const double enough = reached * *std::max_element(sum.begin(), sum.end());
  const auto at = std::find_if(sum.begin(), sum.end(), [&](double value) { return value >= enough; });
  return first + static_cast<std::size_t>(at - sum.begin());
}

std::vector<Candidate> candidatesIn(const BandPower& power, const Evidence& evidence,
                                    const std::vector<double>& travelled, double threshold, double gap) {
  std::vector<Candidate> found;
  std::vector<std::size_t> loudest;
  const auto& value = evidence.value;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (value[i] < threshold / 3) continue;
    const bool isNear = !found.empty() && travelled[i] - travelled[found.back().end - 1] < gap;
    if (!isNear) found.push_back({i, i + 1, i, 0.0}), loudest.push_back(i);
    found.back().end = i + 1;
    if (value[i] > found.back().score) found.back().score = value[i], loudest.back() = i;
  }
  const std::size_t half = cellsOf(anchorHalf, power.step);
  for (std::size_t k = 0; k < found.size(); ++k)
    found[k].anchor = anchorIn(power, evidence.level, loudest[k] > half ? loudest[k] - half : 0,
                               std::min(value.size(), loudest[k] + half));
  std::erase_if(found, [&](const Candidate& candidate) { return candidate.score < threshold; });
  return found;
}

}  // namespace squat::detection
