// Held against the long double functions of the system: another code, with 11 more bits.
#include "core/ElementaryFunctions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace squat {
namespace {

using Function = double (*)(double);
using Reference = long double (*)(long double);

struct Worst {
  double error = 0;  // [units in the last place]
  double at = 0;
};

// Of arguments in a range; a third of them much smaller, down to a billionth.
Worst worstOf(Function function, Reference reference, double lowest, double highest) {
  std::mt19937_64 random(1);
  Worst worst;
  for (int i = 0; i < 200000; ++i) {
    double x = lowest + (highest - lowest) * static_cast<double>(random() >> 11) * 0x1p-53;
    if (i % 3 == 0) x = std::ldexp(x, -static_cast<int>(random() % 30));
    const long double expected = reference(x);
    const double size = std::abs(static_cast<double>(expected));
    const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
    const double error = std::abs(static_cast<double>((function(x) - expected) / unit));
    if (!(error <= worst.error)) worst = {error, x};
  }
  return worst;
}

struct Row {
  const char* name;
  Function function;
  Reference reference;
  double lowest, highest, units;
};

// What the header promises.
TEST(ElementaryFunctions, AreAsExactAsTheySay) {
  const Row rows[] = {
      {"sin", elementary::sin, std::sin, -10, 10, 1},      {"far sin", elementary::sin, std::sin, -1e6, 1e6, 1},
      {"cos", elementary::cos, std::cos, -10, 10, 1},      {"far cos", elementary::cos, std::cos, -1e6, 1e6, 1},
      {"tan", elementary::tan, std::tan, -10, 10, 3},      {"asin", elementary::asin, std::asin, -1, 1, 1},
      {"acos", elementary::acos, std::acos, -1, 1, 3},     {"atan", elementary::atan, std::atan, -20, 20, 3},
      {"exp", elementary::exp, std::exp, -50, 50, 1},      {"far exp", elementary::exp, std::exp, -690, 690, 1},
      {"cbrt", elementary::cbrt, std::cbrt, -1e3, 1e3, 1},
  };
  for (const auto& row : rows) {
    const auto worst = worstOf(row.function, row.reference, row.lowest, row.highest);
    EXPECT_LT(worst.error, row.units) << row.name << " of " << worst.at;
  }
}

TEST(ElementaryFunctions, OfTwoNumbers) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100000; ++i) {
    const auto number = [&] { return std::ldexp(static_cast<double>(random() >> 11) * 0x1p-52 - 1, random() % 8); };
    const double x = number(), y = number();
    // Errors of a few units in the last place.
    ASSERT_NEAR(elementary::hypot(x, y) / std::hypot(x, y), 1, 3e-16) << x << ", " << y;
    ASSERT_NEAR(elementary::atan2(y, x), std::atan2(y, x), 7e-16) << y << ", " << x;
  }
  EXPECT_EQ(elementary::hypot(3, 4), 5);
  EXPECT_EQ(elementary::atan2(0, 1), 0);
  EXPECT_EQ(elementary::atan2(0, -1), std::numbers::pi);
  EXPECT_EQ(elementary::atan2(-1, 0), -std::numbers::pi / 2);
}

TEST(ElementaryFunctions, AtSpecialPlaces) {
  EXPECT_EQ(elementary::sin(0), 0);
  EXPECT_EQ(elementary::cos(0), 1);
  EXPECT_EQ(elementary::exp(0), 1);
  EXPECT_EQ(elementary::asin(1), std::numbers::pi / 2);
  EXPECT_EQ(elementary::asin(-1), -std::numbers::pi / 2);
  EXPECT_EQ(elementary::acos(-1), std::numbers::pi);
  EXPECT_EQ(elementary::acos(1), 0);
  EXPECT_EQ(elementary::cbrt(0), 0);
  EXPECT_EQ(elementary::cbrt(-27), -3);
  EXPECT_EQ(elementary::exp(-1000), 0);
  EXPECT_TRUE(std::isinf(elementary::exp(1000)));
  EXPECT_TRUE(std::isnan(elementary::asin(1.5)) && std::isnan(elementary::acos(-1.5)));
  // What pi lacks as a double: sin of it is not 0.
  EXPECT_NEAR(elementary::sin(std::numbers::pi) / 1.2246467991473531772e-16, 1, 1e-15);
}

// Sums, products and roots of double have the same bits on every system, so these have them as well. The number was
// printed on x86 under Linux; where it differs, the compiler fuses multiplications and additions.
TEST(ElementaryFunctions, HaveTheSameBitsOnEverySystem) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  const auto add = [&](double x) {
    for (int byte = 0; byte < 8; ++byte)
      hash = (hash ^ (std::bit_cast<std::uint64_t>(x) >> (8 * byte) & 255)) * 0x100000001b3;
  };
  for (int i = 1; i < 2000; ++i) {
    const double x = i / 64.0, share = i / 2000.0;
    for (const auto function :
         {elementary::sin, elementary::cos, elementary::tan, elementary::atan, elementary::exp, elementary::cbrt})
      add(function(x));
    add(elementary::asin(share)), add(elementary::acos(share)), add(elementary::hypot(x, share));
    add(elementary::atan2(share, x - 15));
  }
  EXPECT_EQ(hash, 0xe0524e40f24fe01fULL) << std::hex << hash;
}

}  // namespace
}  // namespace squat
