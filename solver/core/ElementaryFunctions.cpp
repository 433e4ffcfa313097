#include "core/ElementaryFunctions.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace squat::elementary {
namespace {

// pi/2 and ln 2 in parts of 33 and more bits: what is left of a product of a part with a whole number of up to 20 bits
// is exact.
struct Parts {
  double first, second, third;
};
constexpr Parts halfPi{0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
constexpr Parts ln2{0x1.62e42fefp-1, 0x1.473de6afp-34, 0x1.3c7673007e5edp-69};

// Coefficients of the power series, by ascending powers of the square.
template <std::size_t N>
constexpr std::array<double, N> reciprocalFactorials(int first, int step, int sign) {
  std::array<double, N> series{};
  double factorial = 1;  // exact up to 18!; above, what an error of its last bit changes is too small to be seen
  int n = 1;
  for (std::size_t i = 0; i < N; ++i) {
    const int power = first + step * static_cast<int>(i);
    for (; n <= power; ++n) factorial *= n;
    series[i] = (sign < 0 && i % 2 == 0 ? -1.0 : 1.0) / factorial;
  }
  return series;
}
constexpr auto sineSeries = reciprocalFactorials<8>(3, 2, -1);    // -1/3!, 1/5!, ...
constexpr auto cosineSeries = reciprocalFactorials<8>(4, 2, +1);  // 1/4!, ..., the signs below
constexpr auto exponentialSeries = reciprocalFactorials<13>(2, 1, +1);

// asin x = x + x^3 (1/6 + 3/40 x^2 + ...), terms of (2n)! / (4^n n!^2 (2n + 1)).
constexpr std::array<double, 25> arcsineSeries = [] {
  std::array<double, 25> series{};
  double binomial = 1;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double n = static_cast<double>(i) + 1;
    binomial *= (2 * n - 1) / (2 * n);
    series[i] = binomial / (2 * n + 1);
  }
  return series;
}();

template <std::size_t N>
double polynomial(const std::array<double, N>& series, double x, std::size_t terms = N) {
  double sum = series[terms - 1];
  for (std::size_t i = terms - 1; i-- > 0;) sum = sum * x + series[i];
  return sum;
}

// The nearest whole number, for |x| up to 2^51.
double nearest(double x) {
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

// What is left of x after a whole number of parts: a value and what rounding left out of it.
struct Remainder {
  double value, rest;
};
Remainder remainderOf(double x, double count, const Parts& parts) {
  const double first = x - count * parts.first, second = count * parts.second;
  const double difference = first - second, part = first - difference;
  const double left = (first - (difference + part)) + (part - second) - count * parts.third;
  const double value = difference + left;
  return {value, (difference - value) + left};
}

double sineOf(const Remainder& r) {  // of up to pi/4
  const double square = r.value * r.value;
  // sin(value + rest) = sin(value) + rest cos(value)
  return r.value + (r.value * square * polynomial(sineSeries, square) + r.rest * (1 - 0.5 * square));
}

double cosineOf(const Remainder& r) {
  const double square = r.value * r.value, half = 0.5 * square, most = 1 - half;
  // cos = 1 - x^2/2 + x^4/4! - x^6/6! ...: the signs change by the sign of the square.
  const double tail = square * square * polynomial(cosineSeries, -square);
  return most + (((1 - most) - half) + (tail - r.value * r.rest));
}

struct Quarter {
  Remainder remainder;
  int number;  // 0 to 3
};
Quarter quarterOf(double x) {
  const double count = nearest(x * (2 * std::numbers::inv_pi));
  return {remainderOf(x, count, halfPi), static_cast<int>(static_cast<long long>(count) & 3)};
}

bool isAngle(double x) { return std::abs(x) <= 1e6; }

// (asin x - x) / x, of a square of up to 1/4.
double arcsineTail(double square) { return square * polynomial(arcsineSeries, square, square < 1.0 / 64 ? 10 : 25); }

}  // namespace

double sin(double x) {
  if (!isAngle(x)) return std::sin(x);
  const auto [remainder, quarter] = quarterOf(x);
  const double size = quarter % 2 == 0 ? sineOf(remainder) : cosineOf(remainder);
  return quarter < 2 ? size : -size;
}

double cos(double x) {
  if (!isAngle(x)) return std::cos(x);
  const auto [remainder, quarter] = quarterOf(x);
  const double size = quarter % 2 == 0 ? cosineOf(remainder) : sineOf(remainder);
  return quarter == 0 || quarter == 3 ? size : -size;
}

double tan(double x) { return sin(x) / cos(x); }

double asin(double x) {
  const double size = std::abs(x);
  if (!(size <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (size <= 0.5) return x + x * arcsineTail(x * x);
  // asin x = pi/2 - 2 asin(sqrt((1 - x) / 2)); the root with what rounding left out of it.
  const double square = 0.5 * (1 - size), root = std::sqrt(square);
  const double split = 0x1p27 * root + root, high = split - (split - root), low = root - high;
  const double rest = root > 0 ? (((square - high * high) - 2 * high * low) - low * low) / (2 * root) : 0.0;
  const double angle = halfPi.first - 2 * root;
  const double left = (halfPi.first - angle) - 2 * root;
  const double result = angle + (left + halfPi.second - 2 * (rest + root * arcsineTail(square)));
  return x < 0 ? -result : result;
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (x > 0.5) {  // near 1 the angle is small, and pi/2 minus the arcsine would leave few digits
    const double square = 0.5 * (1 - x), root = std::sqrt(square);
    return 2 * (root + root * arcsineTail(square));
  }
  return (halfPi.first - asin(x)) + halfPi.second;
}

double atan(double x) {
  if (std::abs(x) > 1) return (x > 0 ? 1 : -1) * ((halfPi.first - atan(1 / std::abs(x))) + halfPi.second);
  return asin(x / std::sqrt(1 + x * x));
}

double atan2(double y, double x) {
  if (x == 0 && y == 0) return std::atan2(y, x);
  if (std::abs(y) > std::abs(x))
    return (y > 0 ? 1 : -1) * halfPi.first - (atan(x / y) - (y > 0 ? 1 : -1) * halfPi.second);
  if (x > 0) return atan(y / x);
  const double side = std::signbit(y) ? -1 : 1;
  return 2 * side * halfPi.first + (atan(y / x) + 2 * side * halfPi.second);
}

double exp(double x) {
  if (!(std::abs(x) < 700)) return std::exp(x);  // nothing, infinite or undefined
  const double count = nearest(x * std::numbers::log2e);
  const Remainder r = remainderOf(x, count, ln2);
  const double square = r.value * r.value;
  return std::ldexp(1 + (r.value + (r.rest + square * polynomial(exponentialSeries, r.value))),
                    static_cast<int>(count));
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double size = std::frexp(std::abs(x), &exponent);  // 0.5 to 1
  const int third = static_cast<int>(std::floor(exponent / 3.0)), left = exponent - 3 * third;
  const double scaled = std::ldexp(size, left);                // 0.5 to 4
  double root = 0.6 + 0.35 * scaled - 0.03 * scaled * scaled;  // within 10 %; Newton's error becomes its square
  for (int i = 0; i < 5; ++i) root -= (root - scaled / (root * root)) / 3;
  return std::ldexp(x < 0 ? -root : root, third);
}

double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace squat::elementary
