#include "case/DecimalNumber.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "text/Text.h"

namespace squat::cases {

namespace {

bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }

std::size_t countDigits(std::string_view text, std::size_t from) {
  std::size_t count = 0;
  while (from + count < text.size() && isDigit(text[from + count])) ++count;
  return count;
}

// [+-] digits [. digits] [e [+-] digits], at least one digit in the mantissa.
struct Parts {
  std::string_view mantissa;  // with its minus sign
  int exponent = 0;
};

std::optional<Parts> split(std::string_view text) {
  const bool plus = !text.empty() && text.front() == '+';
  if (plus) text.remove_prefix(1);
  if (plus && !text.empty() && text.front() == '-') return std::nullopt;
  std::size_t at = !text.empty() && text.front() == '-' ? 1 : 0;
  std::size_t digits = countDigits(text, at);
  at += digits;
  if (at < text.size() && text[at] == '.') {
    const std::size_t decimals = countDigits(text, at + 1);
    digits += decimals;
    at += 1 + decimals;
  }
  if (digits == 0) return std::nullopt;
  Parts parts{text.substr(0, at), 0};
  if (at == text.size()) return parts;
  if (text[at] != 'e' && text[at] != 'E') return std::nullopt;
  ++at;
  if (at < text.size() && text[at] == '+') ++at;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), parts.exponent);
  if (error != std::errc() || end != text.data() + text.size() || !isDigit(text.back())) return std::nullopt;
  if (std::abs(parts.exponent) > 100000) return std::nullopt;
  return parts;
}

}  // namespace

std::optional<double> parseDecimal(std::string_view text, int powerOfTen) {
  const auto parts = split(text::trimmed(text, " \t"));
  if (!parts) return std::nullopt;
  const std::string shifted = std::string(parts->mantissa) + "e" + std::to_string(parts->exponent + powerOfTen);
  double value = 0;
  const auto [end, error] = std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  if (error != std::errc() || end != shifted.data() + shifted.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string formatDecimal(double value, int powerOfTen) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (value == 0) return std::signbit(value) ? "-0" : "0";
  std::array<char, 40> buffer{};
  const auto written =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(written.ptr - buffer.data()));
  const std::size_t e = text.find('e');
  int exponent = std::atoi(std::string(text.substr(e + 1)).c_str()) - powerOfTen;
  std::string digits;
  for (const char letter : text.substr(0, e))
    if (isDigit(letter)) digits += letter;
  const int count = static_cast<int>(digits.size());
  std::string result = value < 0 ? "-" : "";
  if (exponent >= count - 1 && exponent < 16) return result + digits + std::string(exponent - count + 1, '0');
  if (exponent >= 0 && exponent < 16)
    return result + digits.substr(0, exponent + 1) + "." + digits.substr(exponent + 1);
  if (exponent < 0 && exponent >= -5) return result + "0." + std::string(-exponent - 1, '0') + digits;
  result += digits.substr(0, 1);
  if (count > 1) result += "." + digits.substr(1);
  return result + "e" + std::to_string(exponent);
}

}  // namespace squat::cases
