#include "signals/Median.h"

#include <gtest/gtest.h>

namespace squat::signals {
namespace {

TEST(Median, IsTheValueInTheMiddle) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({5, -1, 3}), 3);
  EXPECT_EQ(median({4, 1, 3, 2}), 3) << "of an even number the upper one";
  EXPECT_EQ(median({7, 7, 7, -1e300, 1e300}), 7);
  EXPECT_EQ(median({}), 0);
}

}  // namespace
}  // namespace squat::signals
