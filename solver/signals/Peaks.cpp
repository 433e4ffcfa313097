#include "signals/Peaks.h"

#include <algorithm>

namespace squat::signals {
namespace {

// Walks from the peak to one side until higher ground; returns the lowest value passed and, through `base`, its place.
double lowestBeside(const std::vector<double>& values, std::size_t peak, std::ptrdiff_t side, std::size_t& base) {
  double lowest = values[peak];
  base = peak;
  for (auto i = static_cast<std::ptrdiff_t>(peak); i >= 0 && i < static_cast<std::ptrdiff_t>(values.size());
       i += side) {
    const double value = values[static_cast<std::size_t>(i)];
    if (value > values[peak]) break;
    if (value < lowest) {
      lowest = value;
      base = static_cast<std::size_t>(i);
    }
  }
  return lowest;
}

// Place where the values fall through `level` on the way from the peak to its base.
double crossing(const std::vector<double>& values, std::size_t peak, std::size_t base, double level) {
  const std::ptrdiff_t side = base < peak ? -1 : 1;
  std::size_t i = peak;
  while (i != base && values[i] > level) i = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + side);
  if (values[i] >= level) return static_cast<double>(i);
  const auto before = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) - side);
  return static_cast<double>(i) - static_cast<double>(side) * (level - values[i]) / (values[before] - values[i]);
}

}  // namespace

std::vector<Peak> findPeaks(const std::vector<double>& values, double minimumProminence) {
  std::vector<Peak> peaks;
  const std::size_t n = values.size();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (!(values[i] > values[i - 1])) continue;
    std::size_t end = i;  // of a plateau
    while (end + 1 < n && values[end + 1] == values[i]) ++end;
    if (end + 1 < n && values[end + 1] < values[i]) {
      Peak peak;
      peak.index = (i + end) / 2;
      peak.height = values[i];
      std::size_t leftBase = 0, rightBase = 0;
      const double left = lowestBeside(values, peak.index, -1, leftBase);
      const double right = lowestBeside(values, peak.index, 1, rightBase);
      peak.prominence = peak.height - std::max(left, right);
      if (peak.prominence >= minimumProminence) {
        const double level = peak.height - 0.5 * peak.prominence;
        peak.left = crossing(values, peak.index, leftBase, level);
        peak.right = crossing(values, peak.index, rightBase, level);
        peaks.push_back(peak);
      }
    }
    i = end;
  }
  return peaks;
}

std::vector<SpectralPeak> spectralPeaks(const PowerSpectrum& spectrum, double low, double high, double share) {
  std::vector<SpectralPeak> result;
  const double step = spectrum.step();
  for (const Peak& peak : findPeaks(spectrum.density)) {
    const double before = spectrum.density[peak.index - 1], after = spectrum.density[peak.index + 1];
    const double bend = before - 2 * peak.height + after;
    const double offset = bend < 0 ? 0.5 * (before - after) / bend : 0.0;
    SpectralPeak found;
    found.frequency = spectrum.frequency[peak.index] + offset * step;
    found.density = peak.height - 0.25 * (before - after) * offset;
    found.prominence = peak.prominence;
    found.width = peak.width() * step;
    if (found.frequency >= low && found.frequency <= high) result.push_back(found);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& one, const auto& other) { return one.prominence > other.prominence; });
  const auto small = std::find_if(result.begin(), result.end(), [&](const auto& peak) {
    return peak.prominence < share * result.front().prominence;
  });
  result.erase(small, result.end());
  return result;
}

}  // namespace squat::signals
