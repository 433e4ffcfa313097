// tests/verification/Seen.h - what a test has measured, beside what is stated of it. accuracy.csv holds the stated
// figures of README and manual, of each test and quantity; .ci/verification writes it from the lines that begin with
// "seen:". At its end a test fails where the worst that it has seen of a quantity is 1.5 times as bad as is stated. It
// says, as a message only, where the worst is that much better, and where nothing is stated.
#pragma once

#include <string>
#include <vector>

namespace squat::verification {

// By how much a figure may be worse than is stated: so much that neither round-off nor another instruction set matters
// in a deviation, and that half of the deviation more is found.
inline constexpr double kStatedWithin = 1.5;

struct Stated {
  std::string test;      // its whole name, as GoogleTest has it
  std::string quantity;  // what is measured, and on which mesh where the test has several
  std::string figure;    // two digits, as README and manual print it
  std::string unit;
};

const std::vector<Stated>& statedFigures();

// Of most quantities a larger value is worse; of an effect that has to be there, a smaller one.
enum class Worse { larger, smaller };

// A quantity in the unit of its limit.
void seen(const std::string& what, double value, const std::string& unit, Worse worse = Worse::larger);

// The deviation of `found` from `expected`, in percent of `expected`.
void seenDeviation(const std::string& what, double found, double expected);

// What is wrong with the worst that was seen, told from what is stated; empty where nothing is. `good` is set where the
// statement could be a better one.
std::string judgedAsStated(double worst, double stated, Worse worse, bool& good);

}  // namespace squat::verification
