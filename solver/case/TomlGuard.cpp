#include "case/TomlGuard.h"

#include <algorithm>

namespace squat::cases {

namespace {

// Position behind the string that begins at `at` with a quote, single or triple; the end of the text where it is open.
std::size_t behindString(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool triple = text.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  const std::string_view closing = text.substr(at, triple ? 3 : 1);
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\')
      ++i;
    else if (!triple && text[i] == '\n')
      return i;  // malformed; the parser will say so
    else if (text.substr(i, closing.size()) == closing)
      return i + closing.size();
  }
  return text.size();
}

// Calls `visit(letter, position)` for everything outside strings; of a comment only its # is seen.
template <typename Visit>
void visitOutsideStrings(std::string_view text, const Visit& visit) {
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"' || letter == '\'') {
      at = behindString(text, at);
      continue;
    }
    visit(letter, at);
    at = letter == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
  }
}

}  // namespace

std::size_t mostKeyParts(std::string_view text) {
  std::size_t dots = 0, most = 0;
  visitOutsideStrings(text, [&](char letter, std::size_t) {
    if (letter == '.') most = std::max(most, ++dots);
    if (std::string_view("=,[]{}\n#").find(letter) != std::string_view::npos) dots = 0;
  });
  return most + 1;
}

std::size_t firstForeignByte(std::string_view text) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  const std::size_t begin = text.substr(0, 3) == byteOrderMark ? 3 : 0;
  std::size_t found = std::string_view::npos;
  visitOutsideStrings(text.substr(begin), [&](char letter, std::size_t at) {
    if (found == std::string_view::npos && static_cast<unsigned char>(letter) > 127) found = at + begin;
  });
  return found;
}

}  // namespace squat::cases
