#include "scenario/MeasuredProfile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace squat::scenario {

namespace {

using Points = std::vector<ProfilePoint>;

constexpr double normalDeviation = 1.4826;  // standard deviation of normal noise over its median absolute deviation

// Of an even number of values the mean of the two in the middle; the order of the values is lost.
double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// The indices [from, to) of points about one of them.
struct Window {
  std::size_t at, from, to;
};

// Of a window with more than 500 points, evenly spaced ones stand for all, the one in its middle among them.
void takeHeights(const Points& points, const Window& window, std::vector<double>& heights) {
  constexpr std::size_t most = 500;
  const std::size_t stride = (window.to - window.from) / most + 1;
  heights.clear();
  for (std::size_t i = window.from + (window.at - window.from) % stride; i < window.to; i += stride)
    heights.push_back(points[i].height);
}

// Median of the heights in a window, and their standard deviation if they were normal noise.
struct Spread {
  double median = 0, deviation = 0;
};
Spread spreadOf(const Points& points, const Window& window, std::vector<double>& work) {
  takeHeights(points, window, work);
  const double median = medianOf(work);
  for (double& height : work) height = std::abs(height - median);
  return {median, normalDeviation * medianOf(work)};
}

// Walks along the points with the window of those within half a width of each; `even`: as far on both sides.
template <typename Visit>
void alongWindows(const Points& points, double width, bool even, Visit&& visit) {
  constexpr double roundOff = 1e-9;  // [m] far below any step of an instrument
  std::size_t from = 0, to = 0;
  const double first = points.front().position, last = points.back().position;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].position;
    const double half = (even ? std::min({width / 2, x - first, last - x}) : width / 2) + roundOff;
    while (from > 0 && points[from - 1].position >= x - half) --from;
    while (points[from].position < x - half) ++from;
    while (to > i + 1 && points[to - 1].position > x + half) --to;
    while (to < points.size() && points[to].position <= x + half) ++to;
    visit(Window{i, from, to});
  }
}

Points withoutOutliers(const Points& points, double width) {
  constexpr double farthest = 3;  // standard deviations
  constexpr std::size_t fewest = 5;
  Points result = points;
  std::vector<double> work;
  alongWindows(points, width, false, [&](const Window& window) {
    if (window.to - window.from < fewest) return;
    const auto spread = spreadOf(points, window, work);
    double& height = result[window.at].height;
    if (std::abs(height - spread.median) > farthest * spread.deviation) height = spread.median;
  });
  return result;
}

// The line between the medians of the first and of the last window is taken off meanwhile, so that the one-sided
// windows at the ends have no slope in them.
Points medians(const Points& points, double width) {
  std::vector<double> work;
  std::vector<Window> windows;
  alongWindows(points, width, false, [&](const Window& window) { windows.push_back(window); });
  const auto middle = [&](const Window& window) {
    return ProfilePoint{0.5 * (points[window.from].position + points[window.to - 1].position),
                        spreadOf(points, window, work).median};
  };
  const auto first = middle(windows.front()), last = middle(windows.back());
  const bool isLong = last.position - first.position > width;
  const double grade = isLong ? (last.height - first.height) / (last.position - first.position) : 0;
  Points level = points;
  for (auto& point : level) point.height -= first.height + grade * (point.position - first.position);
  Points result = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    takeHeights(level, windows[i], work);
    result[i].height = medianOf(work) + first.height + grade * (points[i].position - first.position);
  }
  return result;
}

}  // namespace

std::vector<ProfilePoint> countedPoints(const std::vector<ProfilePoint>& points, const Defect& defect) {
  Points counted;
  const bool all = defect.from == defect.to;
  std::copy_if(points.begin(), points.end(), std::back_inserter(counted), [&](const ProfilePoint& point) {
    return all || (point.position >= defect.from && point.position <= defect.to);
  });
  if (counted.empty() || defect.filter == ProfileFilter::none) return counted;
  counted = withoutOutliers(counted, defect.filterWidth);
  return defect.filter == ProfileFilter::median ? medians(counted, defect.filterWidth) : counted;
}

std::vector<std::size_t> pointsApart(const std::vector<ProfilePoint>& points) {
  constexpr double farthest = 10, finest = 1e-6;  // standard deviations; [m]
  constexpr std::size_t half = 3;
  if (points.size() < 2 * half + 1) return {};
  std::vector<double> off, deviations, work;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto spread = spreadOf(points, {i, i < half ? 0 : i - half, std::min(i + half + 1, points.size())}, work);
    off.push_back(std::abs(points[i].height - spread.median));
    deviations.push_back(spread.deviation);
  }
  work = off;
  const double usual = std::max(finest, normalDeviation * medianOf(work));
  std::vector<std::pair<double, std::size_t>> apart;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = points[i].height - points[i - 1].height, behind = points[i].height - points[i + 1].height;
    const double times = off[i] / std::max(usual, deviations[i]);
    const bool alone = before * behind > 0 && std::min(std::abs(before), std::abs(behind)) > 0.7 * off[i];
    if (alone && times > farthest) apart.emplace_back(-times, i);
  }
  std::sort(apart.begin(), apart.end());
  std::vector<std::size_t> found;
  for (const auto& [times, i] : apart) found.push_back(i);
  return found;
}

DeepestPlace deepestPlace(const std::vector<ProfilePoint>& points) {
  constexpr double levelWidth = 0.5;  // [m]
  if (points.empty()) return {};
  Points smooth = points;  // medians of five
  std::vector<double> work, sums{0};
  for (std::size_t i = 2; i + 2 < points.size(); ++i)
    smooth[i].height = spreadOf(points, {i, i - 2, i + 3}, work).median;
  for (const auto& point : smooth) sums.push_back(sums.back() + point.height);
  DeepestPlace deepest{points.front().position, 0};
  alongWindows(smooth, levelWidth, true, [&](const Window& window) {
    const double level = (sums[window.to] - sums[window.from]) / static_cast<double>(window.to - window.from);
    const auto& point = smooth[window.at];
    if (level - point.height > deepest.depth) deepest = {point.position, level - point.height};
  });
  return deepest;
}

double typicalStep(const std::vector<ProfilePoint>& points) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) steps.push_back(points[i].position - points[i - 1].position);
  return steps.empty() ? 0 : medianOf(steps);
}

}  // namespace squat::scenario
