// Signals in closed form and comparisons that the signal tests share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::tests {

inline constexpr double pi = std::numbers::pi;

inline signals::TimeSeries sampled(std::size_t n, double rate, const std::function<double(double)>& value,
                                   double start = 0) {
  signals::TimeSeries series{start, 1 / rate, std::vector<double>(n), "test", "m/s2"};
  for (std::size_t i = 0; i < n; ++i) series.values[i] = value(series.timeAt(i));
  return series;
}

// Largest difference, relative to the largest expected value.
inline double relativeDifference(const std::vector<double>& actual, const std::vector<double>& expected) {
  if (actual.size() != expected.size()) return HUGE_VAL;
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    difference = std::max(difference, std::abs(actual[i] - expected[i]));
    largest = std::max(largest, std::abs(expected[i]));
  }
  return difference / largest;
}

}  // namespace squat::tests
