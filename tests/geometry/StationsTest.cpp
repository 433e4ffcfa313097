// Stations of swept blocks: exact ends, whole vectors, limited growth.
#include "geometry/Stations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace squat::geometry {
namespace {

double lengthOf(const std::vector<StationRun>& runs) {
  double sum = 0;
  for (const auto& run : runs) sum += run.count * run.length;
  return sum;
}

TEST(Stations, CountsAndPositions) {
  Stations stations{-1.0, false, {{8, 0.25}, {16, 0.5}}};
  EXPECT_EQ(stations.intervals(), 24);
  EXPECT_EQ(stations.count(), 25);
  const auto at = stations.positions();
  ASSERT_EQ(at.size(), 25u);
  EXPECT_EQ(at.front(), -1.0);
  EXPECT_EQ(at[8], 1.0);
  EXPECT_EQ(at.back(), 9.0);
  stations.closed = true;
  EXPECT_EQ(stations.count(), 24);
  EXPECT_EQ(stations.positions().size(), 25u);
}

TEST(Stations, GapIsFilledExactlyInWholeVectors) {
  for (const double gap : {0.9, 1.7, 4.3})
    for (const double finerAfter : {0.0, 0.0026}) {
      const auto runs = fillGap(gap, 0.075, 0.0013, finerAfter, 2.0, 8);
      EXPECT_NEAR(lengthOf(runs), gap, 1e-12);
      double before = 0.0013;
      for (const auto& run : runs) {
        EXPECT_EQ(run.count % 8, 0);
        EXPECT_LE(run.length, 0.075 + 1e-12);
        EXPECT_LE(std::max(run.length / before, before / run.length), 2 * (1 + 1e-9));
        before = run.length;
      }
      if (finerAfter > 0) {
        EXPECT_LE(before, 2 * finerAfter * (1 + 1e-9));
      }
    }
}

// The fewest vectors that can fill the gap: with lengths of 1.3 mm 2, 4, 8, 16, 32 times and 75 mm, 8 of each, 0.9 m
// are reached by 8 (2.6 + 5.2 + 10.4 + 20.8 + 41.6 + 75) = 1.24 m and not by 0.64 m without the last.
TEST(Stations, GapTakesNoMoreVectorsThanItNeeds) {
  int count = 0;
  for (const auto& run : fillGap(0.9, 0.075, 0.0013, 0, 2.0, 8)) count += run.count;
  EXPECT_EQ(count, 48);
  count = 0;
  for (const auto& run : fillGap(0.64, 0.075, 0.0013, 0, 2.0, 8)) count += run.count;
  EXPECT_EQ(count, 40);
}

// In groups of 16: one more vector of eight where the fewest were an odd number, the gap as exact as before.
TEST(Stations, GapTakesWholeGroupsWhereAsked) {
  int count = 0;
  const auto runs = fillGap(0.64, 0.075, 0.0013, 0, 2.0, 8, 16);
  for (const auto& run : runs) count += run.count;
  EXPECT_EQ(count, 48);
  EXPECT_NEAR(lengthOf(runs), 0.64, 1e-12);
}

TEST(Stations, ZonesKeepTheirEndsAndLengths) {
  const double start = -4.8, end = 5.2;
  const std::vector<Zone> zones{{-1.02, 0.075},  {-0.98, 0.0013}, {-0.045, 0.005},
                                {0.045, 0.0013}, {0.32, 0.005},   {end, 0.075}};
  const auto stations = stationsOver(start, zones, 2.0, 8);
  const auto at = stations.positions();
  EXPECT_EQ(at.front(), start);
  EXPECT_NEAR(at.back(), end, 1e-9);
  for (const auto& run : stations.runs) EXPECT_EQ(run.count % 8, 0);
  for (std::size_t r = 1; r < stations.runs.size(); ++r) {
    const double ratio = stations.runs[r].length / stations.runs[r - 1].length;
    EXPECT_LE(std::max(ratio, 1 / ratio), 2.0 * (1 + 1e-9)) << "run " << r;
  }
  // Within each fine zone no interval is longer than wished.
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double middle = 0.5 * (at[i] + at[i + 1]);
    double from = start;
    for (const auto& zone : zones) {
      if (middle > from && middle < zone.to) {
        EXPECT_LE(at[i + 1] - at[i], zone.length * (1 + 1e-9)) << middle;
      }
      from = zone.to;
    }
  }
}

}  // namespace
}  // namespace squat::geometry
