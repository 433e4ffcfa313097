// tests/verification/Seen.h - what a test has measured, for the manual's table of verification. .ci/verification reads
// the lines that begin with "seen:" in the output of the tests; of several with one name it takes the largest.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace squat::verification {

// A quantity in the unit of its limit.
inline void seen(const std::string& what, double value, const std::string& unit) {
  std::printf("seen: %s | %.3g | %s\n", what.c_str(), std::abs(value), unit.c_str());
}

// The deviation of `found` from `expected`, in percent of `expected`.
inline void seenDeviation(const std::string& what, double found, double expected) {
  seen(what, 100 * (found / expected - 1), "%");
}

}  // namespace squat::verification
