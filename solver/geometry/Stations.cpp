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

// Lengths of intermediate runs between two lengths, both excluded, in steps of at most `growth`.
std::vector<double> between(double from, double to, double growth) {
  std::vector<double> lengths;
  const double ratio = to / from;
  const int steps = static_cast<int>(std::ceil(std::abs(std::log(ratio)) / std::log(growth) - 1e-9));
  for (int i = 1; i < steps; ++i) lengths.push_back(from * std::pow(ratio, static_cast<double>(i) / steps));
  return lengths;
}

int roundedUp(double intervals, int multiple) {
  return std::max(1, static_cast<int>(std::ceil(intervals / multiple - 1e-6))) * multiple;
}

double lengthOf(const std::vector<StationRun>& runs) {
  double sum = 0;
  for (const auto& run : runs) sum += run.count * run.length;
  return sum;
}

}  // namespace

std::vector<StationRun> fillGap(double gap, double length, double finerBefore, double finerAfter, double growth,
                                int multiple) {
  std::vector<StationRun> before, after;
  if (finerBefore > 0)
    for (const double l : between(finerBefore, length, growth)) before.push_back({multiple, l});
  if (finerAfter > 0)
    for (const double l : between(length, finerAfter, growth)) after.push_back({multiple, l});
  double rest = gap - lengthOf(before) - lengthOf(after);
  while (rest <= 0 && (!before.empty() || !after.empty())) {  // no room: drop the coarsest steps
    if (before.size() >= after.size())
      before.pop_back();
    else
      after.erase(after.begin());
    rest = gap - lengthOf(before) - lengthOf(after);
  }
  const int count = roundedUp(rest / length, multiple);
  before.push_back({count, rest / count});
  before.insert(before.end(), after.begin(), after.end());
  return before;
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
      const int count = roundedUp((to[i] - from[i]) / length, multiple);
      const double extra = count * length - (to[i] - from[i]);
      if (coarserBefore) from[i] -= coarserAfter ? extra / 2 : extra, to[i - 1] = from[i];
      if (coarserAfter) to[i] = from[i] + count * length, from[i + 1] = to[i];
    }
    const double finerBefore = i > 0 && zones[i - 1].length < length ? zones[i - 1].length : 0;
    const double finerAfter = i + 1 < n && zones[i + 1].length < length ? zones[i + 1].length : 0;
    runs[i] = fillGap(to[i] - from[i], length, finerBefore, finerAfter, growth, multiple);
  }
  Stations stations;
  stations.start = start;
  for (const auto& list : runs) stations.runs.insert(stations.runs.end(), list.begin(), list.end());
  return stations;
}

}  // namespace squat::geometry
