// solver/core/OrderedSum.h - work over long vectors by a team, with sums that do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/ThreadTeam.h"

namespace squat {

// Sum of term(i) over [begin, end) in eight lanes that add side by side: one after the other, each addition would wait
// for the one before it.
template <typename Term>
double sumInLanes(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t lanes = 8;
  double sums[lanes] = {};
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) sums[k] += term(i + k);
  for (std::size_t k = 0; i < end; ++i, ++k) sums[k] += term(i);
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

// Calls part(begin, end) for fixed chunks of 0..n and adds what they return to `total` in the order of the chunks.
template <typename Sum, typename Part>
Sum orderedSum(ThreadTeam& team, std::size_t n, Sum total, const Part& part) {
  constexpr std::size_t chunks = 32;
  std::array<Sum, chunks> sums{};
  const std::size_t each = (n + chunks - 1) / chunks;
  team.run([&](int index) {
    for (std::size_t k = index; k < chunks; k += static_cast<std::size_t>(team.size())) {
      const std::size_t begin = std::min(n, k * each), end = std::min(n, begin + each);
      sums[k] = part(begin, end);
    }
  });
  for (const Sum& sum : sums) total += sum;
  return total;
}

// The same for one number.
template <typename Part>
double orderedSum(ThreadTeam& team, std::size_t n, const Part& part) {
  return orderedSum(team, n, 0.0, part);
}

}  // namespace squat
