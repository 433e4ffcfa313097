#include "geometry/Stations.h"

#include <algorithm>
#include <cmath>

namespace squat::geometry {

int Stations::intervals() const {
  int sum = 0;
  for (const auto& run : runs) sum += run.count;
  return sum;
}

std::vector<double> Stations::positions() const {
  std::vector<double> result{start};
  double at = start;
  for (const auto& run : runs) {
    for (int i = 1; i <= run.count; ++i) result.push_back(at + i * run.length);
    at += run.count * run.length;
  }
  return result;
}

namespace {

int roundedUp(double intervals, int multiple) {
  return std::max(1, static_cast<int>(std::ceil(intervals / multiple - 1e-6))) * multiple;
}

// Lengths of `count` blocks that grow by `ratio` from the finer neighbours (0: none) up to `length`.
std::vector<double> ladder(int count, double length, double finerBefore, double finerAfter, double ratio) {
  std::vector<double> lengths(static_cast<std::size_t>(count), length);
  double fromBefore = finerBefore, fromAfter = finerAfter;
  for (int i = 0; i < count; ++i) {
    if (finerBefore > 0) lengths[i] = std::min(lengths[i], fromBefore *= ratio);
    if (finerAfter > 0) lengths[count - 1 - i] = std::min(lengths[count - 1 - i], fromAfter *= ratio);
  }
  return lengths;
}

double sumOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

}  // namespace

std::vector<StationRun> fillGap(double gap, double length, double finerBefore, double finerAfter, double growth,
                                int multiple, int whole) {
  // The fewest blocks of `multiple` intervals that can fill the gap; then the longest are cut, so that they just do.
  const double wanted = gap / multiple;
  const int step = std::max(1, whole / multiple);
  int count = step;
  while (sumOf(ladder(count, length, finerBefore, finerAfter, growth)) < wanted * (1 - 1e-9)) count += step;
  double low = 0, high = length;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (sumOf(ladder(count, middle, finerBefore, finerAfter, growth)) < wanted ? low : high) = middle;
  }
  auto lengths = ladder(count, high, finerBefore, finerAfter, growth);
  const double rest = wanted / sumOf(lengths);  // 1 but for round-off
  std::vector<StationRun> runs;
  for (const double l : lengths) {
    if (!runs.empty() && std::abs(l * rest - runs.back().length) < 1e-9 * l)
      runs.back().count += multiple;
    else
      runs.push_back({multiple, l * rest});
  }
  return runs;
}

Stations stationsOver(double start, const std::vector<Zone>& zones, double growth, int multiple) {
  // Finer zones are laid first and grow by rounding into coarser ones, which fill what is left.
  const int n = static_cast<int>(zones.size());
  std::vector<double> from(n), to(n);
  for (int i = 0; i < n; ++i) from[i] = i ? zones[i - 1].to : start, to[i] = zones[i].to;
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return zones[a].length < zones[b].length; });
  std::vector<std::vector<StationRun>> runs(n);
  for (const int i : order) {
    const double length = zones[i].length;
    const bool coarserBefore = i > 0 && zones[i - 1].length > length;
    const bool coarserAfter = i + 1 < n && zones[i + 1].length > length;
    if (to[i] - from[i] <= 1e-9) continue;
    if (coarserBefore || coarserAfter) {
      const int count = roundedUp((to[i] - from[i]) / length, std::max(multiple, zones[i].whole));
      const double extra = count * length - (to[i] - from[i]);
      if (coarserBefore) from[i] -= coarserAfter ? extra / 2 : extra, to[i - 1] = from[i];
      if (coarserAfter) to[i] = from[i] + count * length, from[i + 1] = to[i];
    }
    // Finer neighbours are laid already: what counts is how long their intervals came out.
    const double finerBefore =
        i > 0 && zones[i - 1].length < length && !runs[i - 1].empty() ? runs[i - 1].back().length : 0;
    const double finerAfter =
        i + 1 < n && zones[i + 1].length < length && !runs[i + 1].empty() ? runs[i + 1].front().length : 0;
    runs[i] = fillGap(to[i] - from[i], length, finerBefore, finerAfter, growth, multiple, zones[i].whole);
  }
  Stations stations;
  stations.start = start;
  for (const auto& list : runs) stations.runs.insert(stations.runs.end(), list.begin(), list.end());
  return stations;
}

std::pair<int, double> intervalOf(const std::vector<double>& positions, double at) {
  const auto above = std::upper_bound(positions.begin(), positions.end(), at) - positions.begin();
  const int k = std::clamp(static_cast<int>(above) - 1, 0, static_cast<int>(positions.size()) - 2);
  return {k, (at - positions[k]) / (positions[k + 1] - positions[k])};
}

}  // namespace squat::geometry
