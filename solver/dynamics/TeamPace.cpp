#include "dynamics/TeamPace.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace squat::dynamics {

namespace {

// A window is long against the turns of some milliseconds in which programs share a core.
constexpr long leastSteps = 32, mostSteps = 4096;
constexpr double leastSeconds = 0.02;
// How long one thread works alone before all are tried again, at first and at most [s].
constexpr double shortestAlone = 0.1, longestAlone = 1.6;
// Shares are cut again where one thread works longer than the mean by this ratio. Sixteen stations, the smallest piece,
// are a few per cent of a share.
constexpr double uneven = 0.03;
constexpr long cutAgain = 2048;  // steps until the next look at most: the patch moves, and its cost changes

// Mean of the steps in which no other program held the core.
double undisturbed(std::vector<double> steps) {
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double limit = 1.5 * *middle;
  double sum = 0;
  long count = 0;
  for (const double seconds : steps)
    if (seconds <= limit) sum += seconds, ++count;
  return sum / static_cast<double>(count);
}

}  // namespace

TeamPace::TeamPace(std::vector<double> otherWork)
    : otherWork_(std::move(otherWork)), clocks_(otherWork_.size()), aloneFor_(shortestAlone), nextCut_(leastSteps) {
  for (auto& own : clocks_) own.clock.steps_.reserve(mostSteps), own.clock.advances_.reserve(mostSteps);
}

void TeamPace::beginWindow() {
  windowSteps_ = 0, windowSeconds_ = 0;
  for (auto& own : clocks_) own.clock.steps_.clear(), own.clock.advances_.clear();
}

bool TeamPace::advanced(long steps, double seconds, double work) {
  if (clocks_.size() == 1) return false;
  windowSteps_ += steps, windowSeconds_ += seconds, done_ += steps;
  if (alone_) {
    if (windowSeconds_ < aloneFor_) return false;
    alone_ = false;
    aloneFor_ = std::min(longestAlone, 2 * aloneFor_);
    beginWindow();
    return false;
  }
  if (windowSteps_ < leastSteps || windowSeconds_ < leastSeconds) return false;
  double one = 0;  // one thread would do all of it
  std::vector<double> advancing;
  for (const auto& own : clocks_) {
    one += undisturbed(own.clock.steps_);
    advancing.push_back(undisturbed(own.clock.advances_));
  }
  alone_ = windowSeconds_ / static_cast<double>(windowSteps_) > one;
  if (!alone_) aloneFor_ = shortestAlone;
  beginWindow();
  return !alone_ && done_ >= nextCut_ && recut(advancing, work);
}

bool TeamPace::recut(const std::vector<double>& busy, double work) {
  nextCut_ = done_ + std::min(cutAgain, done_);
  const double sum = std::accumulate(busy.begin(), busy.end(), 0.0);
  const double mean = sum / static_cast<double>(busy.size());
  if (*std::max_element(busy.begin(), busy.end()) < (1 + uneven) * mean) return false;
  const double perNode = sum / work;
  for (std::size_t i = 0; i < busy.size(); ++i) otherWork_[i] += (busy[i] - mean) / perNode;
  const double least = *std::min_element(otherWork_.begin(), otherWork_.end());
  for (double& extra : otherWork_) extra -= least;
  return true;
}

}  // namespace squat::dynamics
