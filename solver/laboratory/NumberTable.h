// solver/laboratory/NumberTable.h - tables of numbers as CSV, exact and without a locale.
#pragma once

#include <string>
#include <vector>

namespace squat::laboratory {

// Shortest text that reads back to the same double; empty for not-a-number.
std::string numberText(double value);

// A field of a CSV line, in quotes where it holds a comma, a quote or a line break.
std::string csvField(const std::string& text);

// Comma between columns, point as decimal sign, one header line. Columns may differ in length: fields are empty then.
std::string csvColumns(const std::vector<std::string>& names, const std::vector<const std::vector<double>*>& columns);

}  // namespace squat::laboratory
