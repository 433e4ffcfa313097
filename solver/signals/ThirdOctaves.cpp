#include "signals/ThirdOctaves.h"

#include <array>
#include <cmath>

#include "signals/SignalError.h"

namespace squat::signals {
namespace {

constexpr std::array<double, 10> preferred{1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8};

// Band x has its middle at 10^(x/10) kHz.
OctaveBand bandOf(int x) {
  const int decade = x >= 0 ? x / 10 : -((9 - x) / 10), within = x - 10 * decade;
  OctaveBand band;
  band.middle = 1000 * std::pow(10.0, x / 10.0);
  band.nominal = 1000 * preferred[static_cast<std::size_t>(within)] * std::pow(10.0, decade);
  const double half = std::pow(10.0, 0.05);  // G^(1/6)
  band.lowest = band.middle / half;
  band.highest = band.middle * half;
  return band;
}

}  // namespace

std::vector<OctaveBand> thirdOctaveBands(double lowest, double highest) {
  if (!(lowest > 0) || !std::isfinite(lowest) || !std::isfinite(highest))
    throw SignalError("one-third octave bands need limits above 0 Hz");
  std::vector<OctaveBand> bands;
  for (int x = static_cast<int>(std::floor(10 * std::log10(lowest / 1000))) - 1;; ++x) {
    const OctaveBand band = bandOf(x);
    if (!(band.highest <= highest)) return bands;
    if (band.lowest >= lowest) bands.push_back(band);
  }
}

std::vector<double> bandLevels(const PowerSpectrum& spectrum, const std::vector<OctaveBand>& bands, double reference) {
  std::vector<double> levels;
  levels.reserve(bands.size());
  for (const auto& band : bands)
    levels.push_back(10 * std::log10(bandPower(spectrum, band.lowest, band.highest) / (reference * reference)));
  return levels;
}

}  // namespace squat::signals
