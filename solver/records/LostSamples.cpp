#include "records/LostSamples.h"

#include <algorithm>
#include <cmath>

namespace squat::records {
namespace {

constexpr double wholeWithin = 0.2;  // of a step
constexpr long mostSteps = 4;        // that are bridged

// Whole steps from one time to the next; 0: none, or not whole.
long stepsIn(double difference, double step) {
  const double count = std::round(difference / step);
  return count >= 1 && count <= static_cast<double>(mostSteps) &&
                 std::abs(difference - count * step) <= wholeWithin * step
             ? static_cast<long>(count)
             : 0;
}

}  // namespace

bool losesSamples(const std::vector<double>& steps, double median) {
  if (!(median > 0)) return false;
  std::size_t single = 0, several = 0;
  for (const double step : steps) {
    const long count = stepsIn(step, median);
    single += count == 1, several += count > 1;
  }
  return 10 * single >= 9 * steps.size() && several > std::max<std::size_t>(2, steps.size() / 10000);
}

std::size_t bridgeLostSamples(WorkRows& rows, std::size_t from, double step) {
  std::vector<std::size_t> before;  // the row that each row of the result follows, from `from` on
  std::vector<double> part;         // of the way to the row behind it
  for (std::size_t row = from; row < rows.time.size(); ++row) {
    const long count = row > 0 ? stepsIn(rows.time[row] - rows.time[row - 1], step) : 1;
    for (long k = 1; k < count; ++k)
      before.push_back(row - 1), part.push_back(static_cast<double>(k) / static_cast<double>(count));
    before.push_back(row), part.push_back(0);
  }
  const std::size_t added = before.size() - (rows.time.size() - from);
  if (added == 0) return 0;
  const auto bridge = [&](auto& values) {
    if (values.empty()) return;
    const auto old = values;
    values.resize(from);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto here = old[before[i]];
      if (part[i] == 0)
        values.push_back(here);
      else
        values.push_back(here + static_cast<decltype(here)>(part[i] * static_cast<double>(old[before[i] + 1] - here)));
    }
  };
  for (auto& channel : rows.channels) bridge(channel);
  for (auto* values : {&rows.position, &rows.speed, &rows.run, &rows.latitude, &rows.longitude}) bridge(*values);
  bridge(rows.lines);
  bridge(rows.time);  // last: its old values say where
  return added;
}

}  // namespace squat::records
