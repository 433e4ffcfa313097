#include "text/Numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "text/Text.h"

namespace squat::text {

std::optional<double> numberIn(std::string_view field, char decimal) {
  field = trimmed(field);
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  if (field.empty() || field.size() > 64) return std::nullopt;
  // from_chars takes words for not-a-number and infinity as well.
  const char first = field.front() == '-' && field.size() > 1 ? field[1] : field.front();
  if (!((first >= '0' && first <= '9') || first == '.' || first == ',')) return std::nullopt;
  std::array<char, 64> copy;
  if (decimal == ',') {
    if (field.find('.') != std::string_view::npos) return std::nullopt;
    std::replace_copy(field.begin(), field.end(), copy.begin(), ',', '.');
    field = {copy.data(), field.size()};
  }
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> kilometresAndMetresIn(std::string_view field, char decimal) {
  field = trimmed(field);
  if (const std::size_t digit = field.find_first_of("0123456789"); digit != std::string_view::npos && digit > 0) {
    std::string mark(trimmed(field.substr(0, digit)));  // "K12+487.5", "km 12+487.5", "Km.12+487.5"
    for (char& c : mark) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (mark == "k" || mark == "km" || mark == "km.") field.remove_prefix(digit);
  }
  const std::size_t plus = field.find('+', 1);
  if (plus == std::string_view::npos || plus + 1 >= field.size()) return std::nullopt;
  const auto kilometres = numberIn(field.substr(0, plus), decimal), metres = numberIn(field.substr(plus + 1), decimal);
  if (!kilometres || !metres || *kilometres != std::floor(*kilometres) || *metres < 0) return std::nullopt;
  return *kilometres * 1000 + *metres;
}

bool isMissing(std::string_view field) {
  static constexpr std::array<std::string_view, 9> words{"", "-", "nan", "-nan", "n/a", "na", "null", "inf", "-inf"};
  field = trimmed(field);
  const auto same = [&](std::string_view word) {
    return word.size() == field.size() && std::equal(word.begin(), word.end(), field.begin(), [](char lower, char c) {
             return lower == (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
           });
  };
  return std::any_of(words.begin(), words.end(), same);
}

std::string numberText(double value) {
  if (std::isnan(value)) return {};
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string();
}

std::optional<double> numberFromText(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string roundedText(double value) {
  char text[64];
  const bool whole = std::abs(value) < 1e15 && (value == std::floor(value) || std::abs(value) >= 1e4);
  std::snprintf(text, sizeof text, whole ? "%.0f" : "%.4g", value);
  return text;
}

std::string formatted(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string fixedText(double value, int decimals) {
  return std::isfinite(value) ? formatted(("%." + std::to_string(decimals) + "f").c_str(), value) : std::string();
}

}  // namespace squat::text
