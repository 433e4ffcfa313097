// Numbers as text. Expectations: the decimal value typed, rounded once to the nearest double (literals of the
// compiler).
#include "case/DecimalNumber.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace squat::cases {
namespace {

TEST(DecimalNumber, ShiftsTheDecimalPointExactly) {
  EXPECT_EQ(parseDecimal("1300", 6), 1.3e9);
  EXPECT_EQ(parseDecimal("0.15", -3), 0.15e-3);
  EXPECT_EQ(parseDecimal("0.1", -3), 0.0001);  // 0.1 * 1e-3 in floating point is another number
  EXPECT_NE(0.1 * 1e-3, 0.0001 + 1e-19);
  EXPECT_EQ(parseDecimal("38.4", 9), 38.4e9);
  EXPECT_EQ(parseDecimal("-2.5e-3", 3), -2.5);
}

TEST(DecimalNumber, AcceptsTheUsualForms) {
  EXPECT_EQ(parseDecimal(" +7 "), 7);
  EXPECT_EQ(parseDecimal(".5"), 0.5);
  EXPECT_EQ(parseDecimal("5."), 5);
  EXPECT_EQ(parseDecimal("1E+3"), 1000);
  EXPECT_EQ(parseDecimal("\t12\t"), 12);
}

TEST(DecimalNumber, RefusesEverythingElse) {
  for (const char* text :
       {"",     " ",   "nan", "inf", "-inf", "NaN",   "1,5",   "1e",     "1e+",           "e5",   ".",     "-",
        "+",    "--1", "+-1", "1 2", "0x10", "1_000", "1e999", "-1e999", "1e99999999999", "12mm", "1e5.5", "\n1",
        "1.2.3"})
    EXPECT_FALSE(parseDecimal(text).has_value()) << text;
  EXPECT_FALSE(parseDecimal("1e305", 9).has_value());  // overflows only in SI
}

TEST(DecimalNumber, WritesPlainlyWhereThatIsReadable) {
  EXPECT_EQ(formatDecimal(1.3e9, 6), "1300");
  EXPECT_EQ(formatDecimal(0.00015, -3), "0.15");
  EXPECT_EQ(formatDecimal(12450.49), "12450.49");
  EXPECT_EQ(formatDecimal(-0.5), "-0.5");
  EXPECT_EQ(formatDecimal(0), "0");
  EXPECT_EQ(formatDecimal(1e20), "1e20");
  EXPECT_EQ(formatDecimal(1.25e-9), "1.25e-9");
  EXPECT_EQ(formatDecimal(0.0001), "0.0001");
  EXPECT_EQ(formatDecimal(100, 0), "100");
  EXPECT_EQ(formatDecimal(std::nan("")), "nan");
  EXPECT_EQ(formatDecimal(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(DecimalNumber, EveryDoubleComesBackWithTheSameBits) {
  std::mt19937_64 random(20260101);
  int tried = 0;
  while (tried < 20000) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value) || std::abs(value) > 1e290 || std::abs(value) < 1e-290) continue;
    const int power = static_cast<int>(random() % 19) - 9;
    const auto back = parseDecimal(formatDecimal(value, power), power);
    ASSERT_TRUE(back.has_value()) << formatDecimal(value, power);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << formatDecimal(value, power);
    ++tried;
  }
}

TEST(DecimalNumber, KeepsTheSignOfZero) {
  const auto back = parseDecimal(formatDecimal(-0.0, 6), 6);
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(std::signbit(*back));
}

}  // namespace
}  // namespace squat::cases
