// solver/detection/LogSum.h - logarithm of a sum of numbers that are given by their logarithms.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace squat::detection {

// Does not overflow; minus infinity for no numbers.
inline double logSum(const std::vector<double>& logs) {
  if (logs.empty()) return -std::numeric_limits<double>::infinity();
  const double largest = *std::max_element(logs.begin(), logs.end());
  if (!std::isfinite(largest)) return largest;
  double sum = 0;
  for (const double value : logs) sum += std::exp(value - largest);
  return largest + std::log(sum);
}

}  // namespace squat::detection
