// solver/text/Csv.h - this program's own tables: comma-separated values, exact and without a locale.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace squat::text {

// A field of a CSV line, in quotes where it holds a comma, a quote or a line break.
std::string csvField(const std::string& text);

// Comma between columns, point as decimal sign, one header line. Columns may differ in length: fields are empty then.
std::string csvColumns(const std::vector<std::string>& names, const std::vector<const std::vector<double>*>& columns);

// The records of such a text, quotes resolved; a line break inside quotes belongs to its field.
std::vector<std::vector<std::string>> csvRecords(std::string_view text, char delimiter = ',');

}  // namespace squat::text
