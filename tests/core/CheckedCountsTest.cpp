// Counts at the limits of their type, by hand.
#include "core/CheckedCounts.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace squat {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

TEST(CheckedCounts, productAndSumAreEmptyBeyondTheType) {
  EXPECT_EQ(checkedProduct(kMost, std::uint64_t{1}), kMost);
  EXPECT_EQ(checkedProduct(std::uint64_t{0}, kMost), 0U);
  EXPECT_EQ(checkedProduct(kMost / 2 + 1, std::uint64_t{2}), std::nullopt);
  EXPECT_EQ(checkedSum(kMost, std::uint64_t{0}), kMost);
  EXPECT_EQ(checkedSum(kMost, std::uint64_t{1}), std::nullopt);
}

TEST(CheckedCounts, aShareIsExactWhereTheProductIsBeyondTheType) {
  const auto few = shareOf(10, 3, 4);  // 30 = 7 * 4 + 2
  EXPECT_EQ(few.whole, 7U);
  EXPECT_EQ(few.left, 2U);
  const auto most = shareOf(kMost, kMost - 1, kMost);
  EXPECT_EQ(most.whole, kMost - 1);
  EXPECT_EQ(most.left, 0U);
  // m * (m - 2) = (m - 1)^2 - 1 = (m - 2) * (m - 1) + (m - 2)
  const auto uneven = shareOf(kMost, kMost - 2, kMost - 1);
  EXPECT_EQ(uneven.whole, kMost - 2);
  EXPECT_EQ(uneven.left, kMost - 2);
  EXPECT_EQ(shareOf(0, 1, 2).whole, 0U);
}

}  // namespace
}  // namespace squat
