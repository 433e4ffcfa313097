#include "text/Numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace squat::text {
namespace {

TEST(Numbers, PointAndComma) {
  EXPECT_EQ(numberIn(" 1.5e-3 ", '.'), 1.5e-3);
  EXPECT_EQ(numberIn("+2,5", ','), 2.5);
  EXPECT_EQ(numberIn("-,5", ','), -0.5);
  EXPECT_EQ(numberIn("7", ','), 7.0);
  for (const auto* bad : {"", "-", "1,5", "nan", "inf", "1.5x", "0x10", "1e999", "1 2"})
    EXPECT_FALSE(numberIn(bad, '.')) << bad;
  EXPECT_FALSE(numberIn("1.234,5", ','));
  EXPECT_EQ(kilometresAndMetresIn("12+345.6", '.'), 12345.6);
  for (const char* marked : {"K12+487.5", "km 12+487.5", "Km.12+487.5"})
    EXPECT_EQ(kilometresAndMetresIn(marked, '.'), 12487.5) << marked;
  EXPECT_FALSE(kilometresAndMetresIn("pk12+487.5", '.'));
  EXPECT_FALSE(kilometresAndMetresIn("1.5+20", '.'));
  EXPECT_FALSE(kilometresAndMetresIn("1e+20", '.'));
  EXPECT_TRUE(isMissing(" NaN "));
  EXPECT_FALSE(isMissing("5"));
}

// Printed and read back, a number is the same to the last bit; 17 digits are never needed in full.
TEST(Numbers, WrittenAndReadBack) {
  for (const double value : {0.1, 1.0 / 3, -2.5e-300, 6.02214076e23, 0.0, -0.0}) {
    const auto back = numberFromText(numberText(value));
    ASSERT_TRUE(back);
    EXPECT_EQ(std::signbit(*back), std::signbit(value));
    EXPECT_EQ(*back, value);
  }
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(std::nan("")), "");
  EXPECT_EQ(numberFromText(numberText(std::numeric_limits<double>::infinity())),
            std::numeric_limits<double>::infinity());
  for (const char* other : {"", " 1", "1 ", "1,5", "+1"}) EXPECT_FALSE(numberFromText(other)) << other;
}

TEST(Numbers, RoundedForPeople) {
  EXPECT_EQ(roundedText(103.44), "103.4");
  EXPECT_EQ(roundedText(13710), "13710");
  EXPECT_EQ(roundedText(13710.4), "13710");
  EXPECT_EQ(roundedText(0.00012346), "0.0001235");
  EXPECT_EQ(roundedText(-7), "-7");
}

TEST(Numbers, InAFormatOrWithSoManyDecimals) {
  EXPECT_EQ(formatted("%.1f mm", 0.25), "0.2 mm");  // exact in binary: rounded to even
  EXPECT_EQ(formatted("%g Hz", 1250000), "1.25e+06 Hz");
  EXPECT_EQ(fixedText(-1.005, 1), "-1.0");
  EXPECT_EQ(fixedText(12, 3), "12.000");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::infinity(), 2), "");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::quiet_NaN(), 2), "");
}

}  // namespace
}  // namespace squat::text
