#include "laboratory/NumberTable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace squat::laboratory {

std::string numberText(double value) {
  if (std::isnan(value)) return {};
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string();
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string csvColumns(const std::vector<std::string>& names, const std::vector<const std::vector<double>*>& columns) {
  std::string text;
  for (std::size_t c = 0; c < names.size(); ++c) text += (c ? "," : "") + csvField(names[c]);
  text += '\n';
  std::size_t rows = 0;
  for (const auto* column : columns) rows = std::max(rows, column->size());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c) text += ',';
      if (row < columns[c]->size()) text += numberText((*columns[c])[row]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace squat::laboratory
