#include "loggers/SeismicList.h"

#include <gtest/gtest.h>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

const std::string kHeading =
    "TIMESERIES XX_ABA1__HNZ_R, 7 samples, 2000.0 sps, 2024-05-03T10:15:00.000000, SLIST, INTEGER, m/s2\n";

TEST(SeismicList, HoldsOneChannelInItsLines) {
  const auto table = parseSeismicList(kHeading + "1\t2\t3\n4\t5\t6\n-7\n", "test");
  ASSERT_EQ(table.table.columns.size(), 1u);
  EXPECT_EQ(table.table.columns[0].values, (std::vector<double>{1, 2, 3, 4, 5, 6, -7}));
  EXPECT_EQ(table.table.columns[0].name, "XX_ABA1__HNZ_R");
  EXPECT_EQ(table.table.columns[0].unit, "m/s2");
  EXPECT_EQ(table.rate, 2000);
  EXPECT_EQ(table.table.rows(), 7u);
}

// The next stretch begins 7 samples, 3.5 ms, later.
TEST(SeismicList, GoesOnInTheNextStretch) {
  const std::string next =
      "TIMESERIES XX_ABA1__HNZ_R, 2 samples, 2000.0 sps, 2024-05-03T10:15:00.003500, SLIST, INTEGER, m/s2\n";
  const auto table = parseSeismicList(kHeading + "1 2 3 4 5 6 7\n" + next + "8 9\n", "test");
  ASSERT_EQ(table.table.columns.size(), 1u);
  EXPECT_EQ(table.table.columns[0].values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(SeismicList, RefusesWhatItDoesNotHold) {
  EXPECT_THROW(parseSeismicList(kHeading + "1 2 3\n", "test"), FileError) << "cut off";
  EXPECT_THROW(parseSeismicList(kHeading + "1 2 3 4 5 6 x\n", "test"), FileError);
  EXPECT_THROW(parseSeismicList("TIMESERIES X, SLIST\n1 2\n", "test"), FileError);
}

}  // namespace
}  // namespace squat::loggers
