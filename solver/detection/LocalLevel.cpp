#include "detection/LocalLevel.h"

#include <algorithm>
#include <cmath>

namespace squat::detection {

std::vector<double> smoothed(const std::vector<double>& values, std::size_t width) {
  const std::size_t n = values.size();
  std::vector<double> result(n), sums(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) sums[i + 1] = sums[i] + values[i];
  const std::size_t before = (width > 0 ? width - 1 : 0) / 2, behind = width > 0 ? width - 1 - before : 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i > before ? i - before : 0, to = std::min(n, i + behind + 1);
    result[i] = std::max(0.0, (sums[to] - sums[from]) / static_cast<double>(to - from));
  }
  return result;
}

std::vector<double> localLevel(const std::vector<double>& values, std::size_t half, double freedom,
                               const std::vector<bool>& silent) {
  const std::size_t n = values.size();
  std::vector<double> level(n, 0.0);
  if (n == 0) return level;
  half = std::max<std::size_t>(half, 1);
  const std::size_t hop = std::max<std::size_t>(1, half / 4);
  const double meanByMedian = std::pow(1 - 2 / (9 * std::max(freedom, 1.0)), -3);
  std::vector<double> window, medians;
  for (std::size_t centre = 0; centre < n + hop; centre += hop) {
    const std::size_t at = std::min(centre, n - 1);
    // At an end the window keeps its length: half a window would be less sure.
    const std::size_t to = std::min(n, std::max(at, half) + half), from = to > 2 * half ? to - 2 * half : 0;
    window.clear();
    for (std::size_t i = from; i < to; ++i)
      if (silent.empty() || !silent[i]) window.push_back(values[i]);
    if (window.empty()) {
      medians.push_back(0);
      continue;
    }
    const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
    std::nth_element(window.begin(), middle, window.end());
    medians.push_back(*middle * meanByMedian);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i / hop;
    const double share = static_cast<double>(i % hop) / static_cast<double>(hop);
    level[i] = (1 - share) * medians[k] + share * medians[k + 1];
  }
  return level;
}

}  // namespace squat::detection
