#include "case/TomlGuard.h"

#include <algorithm>

namespace squat::cases {

namespace {

constexpr auto npos = std::string_view::npos;

bool isBeyondAscii(char letter) { return static_cast<unsigned char>(letter) > 127; }

// A string that begins with a quote, single or triple.
struct String {
  std::size_t end = 0;               // position behind it; the end of the text where it is open
  std::size_t continuedWith = npos;  // first letter beyond ASCII that follows a backslash of a multi-line basic string
};

// A multi-line string may end in five quotes: two of them are its own.
std::size_t behindClosing(std::string_view text, std::size_t at, char quote) {
  std::size_t end = at + 3;
  while (end < text.size() && end < at + 5 && text[end] == quote) ++end;
  return end;
}

String stringAt(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool triple = text.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  const std::string_view closing = text.substr(at, triple ? 3 : 1);
  String string{text.size(), npos};
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      const std::size_t next = std::min(triple ? text.find_first_not_of(" \t\r\n", i + 1) : i + 1, text.size());
      if (triple && next < text.size() && isBeyondAscii(text[next]) && string.continuedWith == npos)
        string.continuedWith = next;
      i = next == i + 1 ? next : next - 1;  // an escaped letter is passed over, blanks and line ends are
    } else if (!triple && text[i] == '\n') {
      string.end = i;  // malformed; the parser will say so
      return string;
    } else if (text.substr(i, closing.size()) == closing) {
      string.end = triple ? behindClosing(text, i, quote) : i + 1;
      return string;
    }
  }
  return string;
}

// Calls `visit(letter, position)` for everything outside strings, `visitString` for each string; of a comment only its
// # is seen.
template <typename Visit, typename VisitString>
void walk(std::string_view text, const Visit& visit, const VisitString& visitString) {
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"' || letter == '\'') {
      const String string = stringAt(text, at);
      visitString(string);
      at = string.end;
      continue;
    }
    visit(letter, at);
    at = letter == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
  }
}

}  // namespace

std::size_t maximumKeyParts(std::string_view text) {
  std::size_t dots = 0, maximum = 0;
  const auto count = [&](char letter, std::size_t) {
    if (letter == '.') maximum = std::max(maximum, ++dots);
    if (std::string_view("=,[]{}\n#").find(letter) != npos) dots = 0;
  };
  walk(text, count, [](const String&) {});
  return maximum + 1;
}

ForeignByte firstForeignByte(std::string_view text) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  const std::size_t begin = text.substr(0, 3) == byteOrderMark ? 3 : 0;
  ForeignByte found{npos, ForeignByte::Where::outsideStrings};
  const auto look = [&](std::size_t at, ForeignByte::Where where) {
    if (at != npos && found.position == npos) found = {at + begin, where};
  };
  walk(
      text.substr(begin),
      [&](char letter, std::size_t at) {
        if (isBeyondAscii(letter)) look(at, ForeignByte::Where::outsideStrings);
      },
      [&](const String& string) { look(string.continuedWith, ForeignByte::Where::behindBackslash); });
  return found;
}

}  // namespace squat::cases
