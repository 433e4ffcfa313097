#include "text/Lines.h"

#include <algorithm>
#include <utility>

#include "core/Errors.h"
#include "text/Text.h"

namespace squat::text {

Lines::Lines(std::string_view text, std::string path, const std::string& advice) : rest_(text), path_(std::move(path)) {
  const std::string_view head = text.substr(0, 65536);
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF"))
    throw FileError(path_, "", "is UTF-16 text", "Save it as UTF-8 or plain text");
  if (head.find('\0') != std::string_view::npos) throw FileError(path_, "", "is not a text file", advice);
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool Lines::next(std::string_view& line) {
  constexpr std::size_t longest = std::size_t{1} << 20;
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++number_;
  if (line.size() > longest) throw FileError(path_, location(), "is longer than 1 MB", "Put one row on each line");
  return true;
}

bool Lines::nextRow(std::string_view& line) {
  while (next(line))
    if (!isComment(line)) return true;
  return false;
}

std::string Lines::location() const { return number_ > 0 ? "line " + std::to_string(number_) : std::string(); }

bool isComment(std::string_view line) {
  line = trimmed(line);
  return line.empty() || line.front() == '#' || line.front() == '%';
}

void splitFields(std::string_view line, char delimiter, std::vector<std::string_view>& fields) {
  fields.clear();
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  std::size_t from = 0;
  while (from <= line.size()) {
    if (delimiter == ' ')
      while (from < line.size() && isBlank(line[from])) ++from;
    std::size_t quote = from;
    while (delimiter != ' ' && quote < line.size() && line[quote] == ' ') ++quote;
    if (quote < line.size() && line[quote] == '"') {
      const std::size_t close = std::min(line.find('"', quote + 1), line.size());
      fields.push_back(line.substr(quote + 1, close - quote - 1));
      std::size_t end = std::min(close + 1, line.size());
      while (end < line.size() && (delimiter == ' ' ? !isBlank(line[end]) : line[end] != delimiter)) ++end;
      from = end + 1;
      continue;
    }
    std::size_t end = from;
    if (delimiter == ' ')
      while (end < line.size() && !isBlank(line[end])) ++end;
    else
      end = std::min(line.find(delimiter, from), line.size());
    if (delimiter != ' ' || end > from) fields.push_back(line.substr(from, end - from));
    from = end + 1;
  }
}

}  // namespace squat::text
