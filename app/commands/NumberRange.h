// app/commands/NumberRange.h - ranges of numbers in a call.
#pragma once

#include <CLI/CLI.hpp>

namespace squat::commands {

// Both ends are allowed. Not-a-number is in no range, which CLI::Range overlooks.
CLI::Validator between(double low, double high);

// Zero, which stands for a choice of the program's own, or a whole number from low to high.
CLI::Validator zeroOrBetween(long low, long high);

}  // namespace squat::commands
