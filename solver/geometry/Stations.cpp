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

Stations stationsOver(double start, const std::vector<Zone>& zones, double growth, int multiple) {
  // Finer zones are laid first and grow by rounding; a coarser zone fills what its neighbours and transitions leave.
  const int n = static_cast<int>(zones.size());
  std::vector<double> from(n), to(n);
  for (int i = 0; i < n; ++i) from[i] = i ? zones[i - 1].to : start, to[i] = zones[i].to;
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return zones[a].length < zones[b].length; });
  std::vector<std::vector<StationRun>> runs(n);
  for (const int i : order) {
    const double length = zones[i].length;
    const bool finerBefore = i > 0 && zones[i - 1].length < length, finerAfter = i + 1 < n && zones[i + 1].length < length;
    std::vector<StationRun> before, after;
    if (finerBefore)
      for (const double l : between(zones[i - 1].length, length, growth)) before.push_back({multiple, l});
    if (finerAfter)
      for (const double l : between(length, zones[i + 1].length, growth)) after.push_back({multiple, l});
    double rest = to[i] - from[i] - lengthOf(before) - lengthOf(after);
    while (rest < 0 && (!before.empty() || !after.empty())) {  // no room: drop the coarsest steps
      if (before.size() >= after.size()) before.pop_back();
      else after.erase(after.begin());
      rest = to[i] - from[i] - lengthOf(before) - lengthOf(after);
    }
    auto& mine = runs[i];
    mine = before;
    // A zone with a coarser neighbour grows into it; between finer neighbours the length shrinks to fit.
    const bool coarserBefore = i > 0 && zones[i - 1].length > length, coarserAfter = i + 1 < n && zones[i + 1].length > length;
    if (rest > 1e-9) {
      const int count = roundedUp(rest / length, multiple);
      if (coarserBefore || coarserAfter) {
        const double extra = count * length - rest;
        if (coarserBefore && coarserAfter) {
          to[i - 1] = from[i] - extra / 2, to[i] += extra / 2, from[i] -= extra / 2, from[i + 1] = to[i];
        } else if (coarserBefore) {
          from[i] -= extra, to[i - 1] = from[i];
        } else {
          to[i] += extra, from[i + 1] = to[i];
        }
        mine.push_back({count, length});
      } else {
        mine.push_back({count, rest / count});
      }
    }
    mine.insert(mine.end(), after.begin(), after.end());
  }
  Stations stations;
  stations.start = start;
  for (const auto& list : runs) stations.runs.insert(stations.runs.end(), list.begin(), list.end());
  return stations;
}

}  // namespace squat::geometry
