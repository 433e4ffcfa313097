// solver/case/DecimalNumber.h - numbers as text, exact and without a locale.
// A case file holds 1300 for 1300 MN/m, the program 1.3e9 N/m. Its units differ from SI by powers of ten only, so the
// shift is made on the decimal digits, never by a multiplication: text -> SI -> text gives the same text, SI -> text ->
// SI the same bits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace squat::cases {

// The number in `text` times 10^powerOfTen. Accepts sign, digits, decimal point and exponent, blanks around them;
// nothing where the text is anything else (also "nan", "inf", a decimal comma) or the result is not finite.
std::optional<double> parseDecimal(std::string_view text, int powerOfTen = 0);

// Shortest text that parseDecimal(text, powerOfTen) turns into the same bits. Not finite: "nan", "inf", "-inf".
std::string formatDecimal(double value, int powerOfTen = 0);

}  // namespace squat::cases
