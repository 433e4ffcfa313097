// solver/text/Utf8Text.h - names in files that others have written, in one encoding.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace squat::text {

// The text as it is where it is valid UTF-8, else taken for Latin-1, in which every byte is a letter.
std::string asUtf8(std::string_view text);

// Letters outside the basic plane, which units and names of channels do not have, become question marks.
std::string utf8FromUtf16(std::span<const std::uint16_t> letters);

}  // namespace squat::text
