// solver/records/QuickNumber.h - decimal numbers at the speed of long files.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace squat::records {

namespace quick {
inline bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }
inline constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                               1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
}  // namespace quick

// A number at `at`, which then stands behind it; the text must go on with a line end or another mark. Rounded as
// std::from_chars rounds: a whole number below 2^53 and a power of ten up to 22 are exact, and one operation on them
// rounds once (Clinger 1990). False, and nothing moved, for whatever else stands there.
inline bool quickNumber(const char*& at, const char* end, char decimal, double& value) {
  const char* p = at;
  const bool negative = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  const char* first = p;
  std::uint64_t digits = 0;
  for (; quick::isDigit(*p); ++p) digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
  long count = p - first, power = 0;
  if (*p == decimal) {
    const char* fraction = ++p;
    for (; quick::isDigit(*p); ++p) digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
    power = fraction - p;
    count -= power;
  }
  if (count == 0) return false;
  if (*p == 'e' || *p == 'E') {
    const char* e = p + 1;
    const bool down = *e == '-';
    if (*e == '-' || *e == '+') ++e;
    if (!quick::isDigit(*e)) return false;
    long exponent = 0;
    for (; quick::isDigit(*e) && exponent < 10000; ++e) exponent = exponent * 10 + (*e - '0');
    power += down ? -exponent : exponent;
    p = e;
  }
  if (count <= 19 && digits < (std::uint64_t{1} << 53) && power >= -22 && power <= 22) {
    const auto whole = static_cast<double>(digits);
    value = power < 0 ? whole / quick::powers[static_cast<std::size_t>(-power)]
                      : whole * quick::powers[static_cast<std::size_t>(power)];
  } else {
    if (decimal != '.' || !quick::isDigit(*first)) return false;
    const auto [behind, error] = std::from_chars(first, end, value);
    if (error != std::errc() || behind != p || !std::isfinite(value)) return false;
  }
  if (negative) value = -value;
  at = p;
  return true;
}

}  // namespace squat::records
