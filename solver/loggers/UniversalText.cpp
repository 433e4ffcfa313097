#include "loggers/UniversalText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::loggers {

bool UniversalCursor::next(std::string_view& line) {
  if (at_ >= bytes_.size()) return false;
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  line = bytes_.substr(at_, end - at_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  at_ = end + 1 < bytes_.size() ? end + 1 : bytes_.size();
  ++line_;
  return true;
}

void UniversalCursor::skipBytes(std::size_t count) {
  at_ += std::min(count, bytes_.size() - at_);
  binary_ = true;
}

bool UniversalCursor::close(bool* more) {
  std::string_view line;
  while (next(line)) {
    if (isUniversalMark(line)) return true;
    if (more && !text::trimmed(line).empty()) *more = true;
  }
  return false;
}

FileError UniversalCursor::error(const std::string& what, const std::string& advice) const {
  return {path_, binary_ ? "dataset " + std::to_string(dataset_) : "line " + std::to_string(line_), what, advice};
}

bool isUniversalMark(std::string_view line) { return line.find_first_not_of(' ') <= 4 && text::trimmed(line) == "-1"; }

std::string_view universalField(std::string_view line, std::size_t from, std::size_t width) {
  return from < line.size() ? text::trimmed(line.substr(from, width)) : std::string_view();
}

std::optional<long> universalInteger(std::string_view field) {
  field = text::trimmed(field);
  if (field.starts_with('+')) field.remove_prefix(1);
  long value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

std::optional<double> universalNumber(std::string_view field) {
  field = text::trimmed(field);
  if (field.empty() || field.size() > 60) return std::nullopt;
  if (field.find_first_not_of('*') == std::string_view::npos || (text::isMissing(field) && field != "-"))
    return std::numeric_limits<double>::quiet_NaN();
  std::string number(field);
  for (char& c : number)
    if (c == 'D' || c == 'd') c = 'E';
  if (number.find_first_of("eE") == std::string::npos)
    if (const std::size_t sign = number.find_last_of("+-");
        sign != std::string::npos && sign > 0 && sign + 4 == number.size())
      number.insert(sign, 1, 'E');
  return text::numberIn(number, '.');
}

bool universalNumbers(std::string_view line, const std::vector<std::size_t>& widths, std::vector<double>& numbers) {
  const std::size_t before = numbers.size(), narrowest = *std::min_element(widths.begin(), widths.end());
  std::vector<std::string_view> words;
  text::splitFields(line, ' ', words);
  for (const auto word : words) {
    // Digits alone that are wider than a field are two numbers that touch; with a point it is one that does not fit.
    const bool one = word.size() <= narrowest || word.find('.') != std::string_view::npos;
    const auto value = one ? universalNumber(word) : std::nullopt;
    if (!value) break;
    numbers.push_back(*value);
  }
  if (numbers.size() == before + words.size()) return true;

  numbers.resize(before);
  line = line.substr(0, line.find_last_not_of(" \t") + 1);
  for (std::size_t at = 0, field = 0; at < line.size(); ++field) {
    const std::size_t width = widths[field % widths.size()];
    const auto value = universalNumber(universalField(line, at, width));
    if (!value) return false;
    numbers.push_back(*value);
    at += width;
  }
  return true;
}

}  // namespace squat::loggers
