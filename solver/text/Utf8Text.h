// solver/text/Utf8Text.h - names in tables that others have written, in one encoding.
#pragma once

#include <string>
#include <string_view>

namespace squat::text {

// The text as it is where it is valid UTF-8, else taken for Latin-1, in which every byte is a letter.
std::string asUtf8(std::string_view text);

}  // namespace squat::text
