// Expected seconds by hand: 2026-11-27 is day 20784 since 1970 (56 years with 14 leap days, 330 days into the year);
// 9:30 is 34,200 s.
#include "text/Moments.h"

#include <gtest/gtest.h>

namespace squat::text {
namespace {

constexpr double kDay = 86400.0 * (56 * 365 + 14 + 330);
constexpr double kHalfPastNine = 9.5 * 3600;
constexpr double kDoubleStep = 2.4e-7;  // [s] between doubles of this size

struct WrittenMoment {
  const char* text;
  MomentKind kind;
  double seconds;
};

class WrittenMoments : public testing::TestWithParam<WrittenMoment> {};

TEST_P(WrittenMoments, AreRead) {
  const auto moment = momentIn(GetParam().text);
  ASSERT_TRUE(moment) << GetParam().text;
  EXPECT_EQ(moment->kind, GetParam().kind) << GetParam().text;
  EXPECT_NEAR(moment->seconds, GetParam().seconds, kDoubleStep) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    OfLoggersAndOffices, WrittenMoments,
    testing::Values(WrittenMoment{"2026-11-27", MomentKind::date, kDay},
                    WrittenMoment{"27.11.2026", MomentKind::date, kDay},
                    WrittenMoment{"27/11/2026", MomentKind::date, kDay},
                    WrittenMoment{"11/27/2026", MomentKind::date, kDay},
                    WrittenMoment{"27.11.26", MomentKind::date, kDay},
                    WrittenMoment{"2026-11-27T09:30:00Z", MomentKind::dateTime, kDay + kHalfPastNine},
                    WrittenMoment{"2026-11-27 09:30:00.000125", MomentKind::dateTime, kDay + kHalfPastNine + 125e-6},
                    WrittenMoment{"2026-11-27T09:30:00,5", MomentKind::dateTime, kDay + kHalfPastNine + 0.5},
                    WrittenMoment{"2026-11-27T10:30:00+01:00", MomentKind::dateTime, kDay + kHalfPastNine},
                    WrittenMoment{"2026-11-27T05:00:00-0430", MomentKind::dateTime, kDay + kHalfPastNine},
                    WrittenMoment{"2026/11/27 09:30:00", MomentKind::dateTime, kDay + kHalfPastNine},
                    WrittenMoment{"27.11.2026 09:30", MomentKind::dateTime, kDay + kHalfPastNine},
                    WrittenMoment{"27.11.2026 09:30:00,25", MomentKind::dateTime, kDay + kHalfPastNine + 0.25},
                    WrittenMoment{"11/27/2026 9:30:00 PM", MomentKind::dateTime, kDay + kHalfPastNine + 43200},
                    WrittenMoment{"27/11/2026 12:10:00 AM", MomentKind::dateTime, kDay + 600},
                    WrittenMoment{"09:30:00.5", MomentKind::clock, kHalfPastNine + 0.5},
                    WrittenMoment{"9:30:00", MomentKind::clock, kHalfPastNine},
                    WrittenMoment{"30:01,5", MomentKind::clock, 1801.5}));

class NoMoments : public testing::TestWithParam<const char*> {};

TEST_P(NoMoments, AreRefused) { EXPECT_FALSE(momentIn(GetParam())) << GetParam(); }

INSTANTIATE_TEST_SUITE_P(OfOtherTexts, NoMoments,
                         testing::Values("", "1234567", "-12.5e+003", "12+345.6", "1.234.567", "2026-13-01",
                                         "2026-02-30", "2026-11-27 25:00:00", "2026-11-27 09:61:00",
                                         "2026-11-27x09:30:00", "2026-11-27T09:30:00 CET", "9:30", "192.168.100.1",
                                         "27.11.2026 09:30:00,", "1:2:3:4:5:6:7", "2026-11-27T10:30:00+1"));

}  // namespace
}  // namespace squat::text
