#include "text/Utf8Text.h"

#include <cstddef>

namespace squat::text {
namespace {

unsigned byteAt(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// Bytes of the letter at `i`; 0: none (RFC 3629, without overlong forms and surrogates).
std::size_t lengthAt(std::string_view text, std::size_t i) {
  const unsigned first = byteAt(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byteAt(text, i + k) & 0xC0u) != 0x80u) return 0;
  const unsigned second = byteAt(text, i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool outside = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return overlong || outside ? 0 : length;
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = lengthAt(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

// A letter of the basic plane (RFC 3629).
void append(std::string& text, unsigned letter) {
  if (letter < 0x80) {
    text += static_cast<char>(letter);
    return;
  }
  if (letter < 0x800) {
    text += static_cast<char>(0xC0u | letter >> 6);
  } else {
    text += static_cast<char>(0xE0u | letter >> 12);
    text += static_cast<char>(0x80u | (letter >> 6 & 0x3Fu));
  }
  text += static_cast<char>(0x80u | (letter & 0x3Fu));
}

}  // namespace

std::string asUtf8(std::string_view text) {
  if (isUtf8(text)) return std::string(text);
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) append(result, byteAt(text, i));
  return result;
}

std::string utf8FromUtf16(std::span<const std::uint16_t> letters) {
  std::string result;
  for (const unsigned letter : letters) append(result, letter >= 0xD800 && letter < 0xE000 ? '?' : letter);
  return result;
}

}  // namespace squat::text
