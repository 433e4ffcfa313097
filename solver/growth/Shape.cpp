#include "growth/Shape.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace squat::growth {

Dip dipOf(const std::vector<double>& x, const std::vector<double>& height) {
  Dip dip;
  if (x.empty()) return dip;
  const auto deepest = static_cast<std::size_t>(std::min_element(height.begin(), height.end()) - height.begin());
  dip.depth = std::max(0.0, -height[deepest]), dip.place = x[deepest];
  if (dip.depth == 0) return dip;
  const double edge = -0.05 * dip.depth;
  const auto crossing = [&](std::size_t in, std::size_t out) {
    return x[in] + (edge - height[in]) / (height[out] - height[in]) * (x[out] - x[in]);
  };
  double from = x.front(), to = x.back();
  for (std::size_t i = deepest; i > 0; --i)
    if (height[i - 1] > edge) {
      from = crossing(i, i - 1);
      break;
    }
  for (std::size_t i = deepest; i + 1 < x.size(); ++i)
    if (height[i + 1] > edge) {
      to = crossing(i, i + 1);
      break;
    }
  dip.length = to - from;
  return dip;
}

WaveSpectrum waveSpectrum(const std::vector<double>& x, const std::vector<double>& height, double from, double to) {
  // Stations stand at unequal distances: each counts with the way to its neighbours.
  std::vector<double> at, z, weight;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from || x[i] > to) continue;
    const double before = i > 0 ? x[i - 1] : x[i], behind = i + 1 < x.size() ? x[i + 1] : x[i];
    at.push_back(x[i]), z.push_back(height[i]), weight.push_back(0.5 * (behind - before));
  }
  WaveSpectrum spectrum;
  if (at.size() < 5) return spectrum;
  double n = 0, sx = 0, sz = 0, sxx = 0, sxz = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    n += weight[i], sx += weight[i] * at[i], sz += weight[i] * z[i];
    sxx += weight[i] * at[i] * at[i], sxz += weight[i] * at[i] * z[i];
  }
  const double slope = (n * sxz - sx * sz) / (n * sxx - sx * sx), offset = (sz - slope * sx) / n;
  double window = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double s = std::sin(std::numbers::pi * (at[i] - at.front()) / (at.back() - at.front()));
    z[i] = (z[i] - offset - slope * at[i]) * weight[i] * s * s;
    window += weight[i] * s * s;
  }
  for (double length = shortestWave; length <= longestWave; length += 0.0005) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < at.size(); ++i) sum += std::polar(z[i], 2 * std::numbers::pi * at[i] / length);
    spectrum.length.push_back(length), spectrum.height.push_back(4 * std::abs(sum) / window);
  }
  return spectrum;
}

Wave strongestWave(const WaveSpectrum& spectrum) {
  Wave wave;
  for (std::size_t i = 1; i + 1 < spectrum.length.size(); ++i) {
    const double height = spectrum.height[i];
    if (height < spectrum.height[i - 1] || height < spectrum.height[i + 1] || height <= wave.height) continue;
    wave = {spectrum.length[i], height};
  }
  return wave;
}

}  // namespace squat::growth
