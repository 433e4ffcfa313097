// solver/rcmdx/TimeBracket.h - between which of some rising times a time lies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace squat::rcmdx {

struct Bracket {
  std::size_t before = 0, after = 0;  // equal where there is only one time
  double weight = 0;                  // of `after`; below 0 or above 1: beyond the first or the last time
  std::size_t nearer() const { return weight < 0.5 ? before : after; }
};

// Quick for times that rise from call to call.
class BracketFinder {
 public:
  explicit BracketFinder(const std::vector<std::int64_t>& times) : times_(&times) {}

  // There must be a time.
  Bracket at(std::int64_t time) {
    const auto& times = *times_;
    if (times.size() == 1) return {};
    const std::size_t last = times.size() - 2;
    if (time < times[at_] || (at_ < last && time >= times[std::min(at_ + 2, last)])) {
      const auto above = std::upper_bound(times.begin(), times.end(), time);
      at_ = std::min(last, static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - times.begin(), 1)) - 1);
    }
    while (at_ < last && time >= times[at_ + 1]) ++at_;
    const double step = static_cast<double>(times[at_ + 1] - times[at_]);
    return {at_, at_ + 1, step > 0 ? static_cast<double>(time - times[at_]) / step : 0.0};
  }

 private:
  const std::vector<std::int64_t>* times_;
  std::size_t at_ = 0;
};

}  // namespace squat::rcmdx
