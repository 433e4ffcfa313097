// How threads keep pace: shares follow the time that each of them works, stalls send one thread alone.
#include "dynamics/TeamPace.h"

#include <gtest/gtest.h>

namespace squat::dynamics {
namespace {

constexpr double micro = 1e-6;
constexpr double work = 1000;  // nodes

// A window in which each thread gathers for 10 us and advances for its time, and a step takes `wall` of the clock.
bool afterWindow(TeamPace& pace, double first, double second, double wall, long disturbed = 0) {
  constexpr long steps = 200;
  for (long k = 0; k < steps; ++k) {
    const double lost = k < disturbed ? 4000 : 0;  // a turn of another program
    pace.clock(0).add(10 * micro, (first + lost) * micro);
    pace.clock(1).add(10 * micro, second * micro);
  }
  return pace.advanced(steps, steps * wall * micro, work);
}

TEST(TeamPace, LeavesEvenSharesAlone) {
  TeamPace pace({500, 0});
  EXPECT_FALSE(afterWindow(pace, 200, 202, 215));
  EXPECT_FALSE(pace.alone());
  EXPECT_EQ(pace.otherWork(), (std::vector<double>{500, 0}));
}

// 300 and 100 us for 1000 nodes are 0.4 us a node: even shares move 250 nodes to the second thread, which is what 500
// nodes more besides the first one's stations do.
TEST(TeamPace, CutsAnewWhereOneThreadWorksLonger) {
  TeamPace pace({500, 0});
  EXPECT_TRUE(afterWindow(pace, 300, 100, 320));
  EXPECT_NEAR(pace.otherWork()[0] - pace.otherWork()[1], 500 + 500, 1e-6);
  EXPECT_FALSE(pace.alone());
}

TEST(TeamPace, MovesWorkBothWays) {
  TeamPace pace({500, 0});
  EXPECT_TRUE(afterWindow(pace, 100, 300, 320));
  EXPECT_NEAR(pace.otherWork()[0] - pace.otherWork()[1], 0, 1e-6);
}

// Steps in which another program held the core say nothing of the work.
TEST(TeamPace, OverlooksDisturbedSteps) {
  TeamPace pace({0, 0});
  EXPECT_FALSE(afterWindow(pace, 200, 200, 300, 20));
}

// Both together work 420 us a step; a step of 500 us would be done sooner by one of them.
TEST(TeamPace, OneGoesAloneWhereWaitingCostsMoreThanItsHelpGains) {
  TeamPace pace({0, 0});
  EXPECT_FALSE(afterWindow(pace, 200, 200, 415));
  EXPECT_FALSE(pace.alone());
  EXPECT_FALSE(afterWindow(pace, 200, 200, 500));
  EXPECT_TRUE(pace.alone());
  // For a tenth of a second, then all are tried; for twice as long where that is in vain.
  EXPECT_FALSE(pace.advanced(100, 0.06, work));
  EXPECT_TRUE(pace.alone());
  EXPECT_FALSE(pace.advanced(100, 0.06, work));
  EXPECT_FALSE(pace.alone());
  afterWindow(pace, 200, 200, 500);
  EXPECT_TRUE(pace.alone());
  pace.advanced(100, 0.15, work);
  EXPECT_TRUE(pace.alone());
  pace.advanced(100, 0.06, work);
  EXPECT_FALSE(pace.alone());
}

TEST(TeamPace, OneThreadHasNobodyToWaitFor) {
  TeamPace pace({0});
  for (int k = 0; k < 100; ++k) pace.clock(0).add(1e-5, 1e-4);
  EXPECT_FALSE(pace.advanced(100, 10, work));
  EXPECT_FALSE(pace.alone());
}

}  // namespace
}  // namespace squat::dynamics
