#include "text/Csv.h"

#include <algorithm>
#include <utility>

#include "text/Numbers.h"

namespace squat::text {

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
  for (std::size_t c = 0; c < names.size(); ++c) text.append(c ? "," : "").append(csvField(names[c]));
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

std::vector<std::vector<std::string>> csvRecords(std::string_view text, char delimiter) {
  std::vector<std::vector<std::string>> records;
  std::vector<std::string> record;
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c != '"')
        field += c;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else
        quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == delimiter || c == '\n') {
      record.push_back(std::move(field));
      field.clear();
      if (c == '\n') records.push_back(std::move(record)), record.clear();
    } else if (c != '\r') {
      field += c;
    }
  }
  if (!field.empty() || !record.empty()) {
    record.push_back(std::move(field));
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace squat::text
