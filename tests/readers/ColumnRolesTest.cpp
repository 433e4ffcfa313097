#include "readers/ColumnRoles.h"

#include <gtest/gtest.h>

namespace squat::readers {
namespace {

TEST(ColumnRoles, byNameAndUnit) {
  EXPECT_EQ(roleOf("Time", ""), Role::time);
  EXPECT_EQ(roleOf("time_s", ""), Role::time);
  EXPECT_EQ(roleOf("Zeit", "s"), Role::time);
  EXPECT_EQ(roleOf("chainage", "km"), Role::position);
  EXPECT_EQ(roleOf("km", ""), Role::position);
  EXPECT_EQ(roleOf("Speed", "km/h"), Role::speed);
  EXPECT_EQ(roleOf("aba", "m/s2"), Role::signal);
  EXPECT_EQ(roleOf("vertical", ""), Role::signal);
  EXPECT_EQ(roleOf("timeliness", ""), Role::signal);
  EXPECT_DOUBLE_EQ(scaleOf("km/h", "v", Role::speed).factor, 1 / 3.6);
  EXPECT_DOUBLE_EQ(scaleOf("", "km", Role::position).factor, 1000);
  EXPECT_EQ(scaleOf("g", "aba", Role::signal).unit, "m/s2");
  EXPECT_EQ(scaleOf("counts", "aba", Role::signal).unit, "counts");
}

}  // namespace
}  // namespace squat::readers
