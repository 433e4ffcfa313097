// solver/detection/Shares.h - random numbers that are the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace squat::detection {

struct Range {
  double low = 0, high = 0;
};

class Shares {
 public:
  explicit Shares(std::uint32_t seed) : engine_(seed) {}
  // [0, 1)
  double operator()() { return static_cast<double>(engine_()) / 4294967296.0; }
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  // Even over the logarithm.
  double within(const Range& range) { return range.low * std::pow(range.high / range.low, (*this)()); }
  double sign() { return (*this)() < 0.5 ? -1 : 1; }

 private:
  std::mt19937 engine_;
};

}  // namespace squat::detection
