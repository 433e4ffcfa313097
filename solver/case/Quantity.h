// solver/case/Quantity.h - numbers with a unit behind them, "108 km/h", for every key whose unit is known.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/ParameterTable.h"

namespace squat::cases {

// The number in SI: in the unit of the case file where none is given, else in a unit of the same quantity. Nothing
// where the text is anything else. Exact as DecimalNumber.h but for units that are no power of ten (km/h, rpm).
std::optional<double> parseQuantity(std::string_view text, const Parameter& parameter);

// The units that are accepted, "m/s, km/h"; empty for a number without unit.
std::string knownUnits(const Parameter& parameter);

}  // namespace squat::cases
