// tests/verification/Seen.h - what a test has measured, for the table of verification in the manual: .ci/verification
// reads the lines that begin with "seen:" from the output of the tests, and of several with one name the largest.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace squat::verification {

// A quantity in the unit of its limit.
inline void seen(const std::string& what, double value, const std::string& unit) {
  std::printf("seen: %s | %.3g | %s\n", what.c_str(), std::abs(value), unit.c_str());
}

// By how much `found` deviates from `expected`, as a share of it.
inline void seenDeviation(const std::string& what, double found, double expected) {
  seen(what, 100 * (found / expected - 1), "%");
}

}  // namespace squat::verification
