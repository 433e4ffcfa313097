// solver/measured/TextNumber.h - numbers as they stand in tables, without a locale.
#pragma once

#include <optional>
#include <string_view>

namespace squat::measured {

std::string_view trimmed(std::string_view text);

// Whole field, blanks around it allowed; decimal point or comma as told. Nothing for text, an empty field, "nan", "inf"
// and numbers beyond the range of double.
std::optional<double> numberIn(std::string_view field, char decimal);

// "12+345.6": kilometres and metres, as metres.
std::optional<double> kilometresAndMetresIn(std::string_view field, char decimal);

// An empty field or a word for "no value" (nan, n/a, null, -).
bool isMissing(std::string_view field);

}  // namespace squat::measured
