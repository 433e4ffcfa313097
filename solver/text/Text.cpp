#include "text/Text.h"

#include <algorithm>

namespace squat::text {

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& letter : result)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return result;
}

std::vector<std::string> split(std::string_view text, char mark) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(mark, from), text.size());
    parts.emplace_back(trimmed(text.substr(from, end - from)));
    from = end + 1;
  }
  return parts;
}

std::string shown(std::string_view field) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char letter : field.substr(0, longest))
    result += static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f ? '?' : letter;
  return result + (field.size() > longest ? "...'" : "'");
}

}  // namespace squat::text
