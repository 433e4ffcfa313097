// solver/text/Numbers.h - numbers in text, without a locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace squat::text {

// Whole field, blanks around it allowed; decimal point or comma as `decimal` says. Nothing for text, an empty field,
// "nan", "inf" and numbers beyond the range of double.
std::optional<double> numberIn(std::string_view field, char decimal);

// "12+345.6": kilometres and metres, as metres.
std::optional<double> kilometresAndMetresIn(std::string_view field, char decimal);

// An empty field or a word for "no value" (nan, n/a, null, -).
bool isMissing(std::string_view field);

// Shortest text that reads back to the same double; empty for not-a-number.
std::string numberText(double value);

// What numberText wrote; nothing for any other text.
std::optional<double> numberFromText(std::string_view text);

// For people: four significant digits; whole numbers, and those from 10,000 on, without decimals.
std::string roundedText(double value);

// printf's text of one number: formatted("%.1f mm", 0.25).
std::string formatted(const char* format, double value);

// With so many decimals; empty where the value is not finite.
std::string fixedText(double value, int decimals);

}  // namespace squat::text
