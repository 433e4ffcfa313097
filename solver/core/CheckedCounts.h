// solver/core/CheckedCounts.h - arithmetic with counts that an untrusted file states.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

namespace squat {

// Empty where the result is beyond the type.
template <std::unsigned_integral Count>
std::optional<Count> checkedProduct(Count a, Count b) {
  if (a != 0 && b > std::numeric_limits<Count>::max() / a) return std::nullopt;
  return static_cast<Count>(a * b);
}

template <std::unsigned_integral Count>
std::optional<Count> checkedSum(Count a, Count b) {
  if (b > std::numeric_limits<Count>::max() - a) return std::nullopt;
  return static_cast<Count>(a + b);
}

struct Share {
  std::uint64_t whole = 0, left = 0;  // rounded down; what the division leaves
};

// count * part / all, for `part` below `all`. The product may be beyond the type: it is added up bit by bit of `count`,
// highest first, and divided meanwhile.
inline Share shareOf(std::uint64_t count, std::uint64_t part, std::uint64_t all) {
  Share share;
  const auto add = [&](std::uint64_t value) {  // below `all`, as is what is left
    const bool isFull = value >= all - share.left;
    share.left = isFull ? value - (all - share.left) : share.left + value;
    share.whole += isFull ? 1 : 0;
  };
  for (int bit = 63; bit >= 0; --bit) {
    share.whole *= 2;
    add(share.left);
    if ((count >> bit & 1U) != 0) add(part);
  }
  return share;
}

}  // namespace squat
