// Headings as loggers, spreadsheets and scripts write them. The expectations are what a reader of the file would say.
#include "text/Heading.h"

#include <gtest/gtest.h>

#include "text/Units.h"

namespace squat::text {
namespace {

struct Written {
  const char *text, *name, *unit;
};

TEST(Heading, UnitsAreFoundWhereverTheyStand) {
  for (const Written& one : {Written{"aba [m/s2]", "aba", "m/s2"},
                             {"aba (g)", "aba", "g"},
                             {"time_ms", "time", "ms"},
                             {"time ms", "time", "ms"},
                             {"time, ms", "time", "ms"},
                             {"Zeit/ms", "Zeit", "ms"},
                             {"Time-us", "Time", "us"},
                             {"time in ms", "time", "ms"},
                             {"speed_kmh", "speed", "kmh"},
                             {"speed km/h", "speed", "km/h"},
                             {"Geschwindigkeit in km/h", "Geschwindigkeit", "km/h"},
                             {"vitesse_kmh", "vitesse", "kmh"},
                             {"chainage_km", "chainage", "km"},
                             {"aba_g", "aba", "g"},
                             {"aba_left_g", "aba_left", "g"},
                             {"acc_ms2", "acc", "m/s2"},
                             {"speed_ms", "speed", "m/s"}}) {
    const auto heading = headingOf(one.text);
    EXPECT_EQ(heading.name, one.name) << one.text;
    EXPECT_EQ(heading.unit, one.unit) << one.text;
  }
}

TEST(Heading, AWordThatIsNoUnitOfTheQuantityStaysInTheName) {
  for (const char* text : {"left_v", "x_g", "aba_left", "aba_v", "time_m", "speed_g", "box n", "run_s", "timeliness_ms",
                           "aba", "time", ""}) {
    const auto heading = headingOf(text);
    EXPECT_EQ(heading.name, text);
    EXPECT_EQ(heading.unit, "") << text;
  }
}

TEST(Heading, OfAKnownQuantityAnyUnitOfItCounts) {
  EXPECT_EQ(headingOf("x mm", "m").unit, "mm");
  EXPECT_EQ(headingOf("z, \xCE\xBCm", "m").name, "z");
  EXPECT_EQ(headingOf("left_g", "m").unit, "");
  EXPECT_EQ(headingOf("height", "m").name, "height");
}

TEST(Heading, WithARowOfUnitsOnlyBracketsPart) {
  EXPECT_EQ(bracketedHeading("time_ms").name, "time_ms");
  EXPECT_EQ(bracketedHeading("time [ms]").unit, "ms");
}

// Factors by definition: international mile, foot and inch (1959), standard gravity (1901), nautical mile (1929).
TEST(Heading, UnitsHaveTheirFactors) {
  const std::pair<const char*, double> factors[] = {
      {"msec", 1e-3},           {"min", 60},     {"mile", 1609.344}, {"inch", 0.0254}, {"ft", 0.3048}, {"mph", 0.44704},
      {"knots", 1852 / 3600.0}, {"cm/s2", 1e-2}, {"ft/s2", 0.3048},  {"gn", 9.80665},  {"um", 1e-6},   {"kmh", 1 / 3.6},
      {"milliseconds", 1e-3},   {"hours", 3600}, {"days", 86400},    {"metres", 1},    {"m s-1", 1},   {"m/sec2", 1}};
  for (const auto& [unit, factor] : factors) {
    ASSERT_TRUE(findUnit(unit)) << unit;
    EXPECT_DOUBLE_EQ(findUnit(unit)->factor, factor) << unit;
  }
}

}  // namespace
}  // namespace squat::text
