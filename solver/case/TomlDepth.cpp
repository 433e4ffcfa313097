#include "case/TomlDepth.h"

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

}  // namespace

std::size_t mostKeyParts(std::string_view text) {
  std::size_t dots = 0, most = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"' || letter == '\'') {
      at = behindString(text, at);
      continue;
    }
    if (letter == '#')
      at = std::min(text.find('\n', at), text.size());
    else
      ++at;
    if (letter == '.') most = std::max(most, ++dots);
    if (std::string_view("=,[]{}\n#").find(letter) != std::string_view::npos) dots = 0;
  }
  return most + 1;
}

}  // namespace squat::cases
