// solver/case/TomlGuard.h - guards in front of the TOML parser; internal to solver/case.
#pragma once

#include <cstddef>
#include <string_view>

namespace squat::cases {

// Largest number of parts that a key of the text has: 2 for "pad.stiffness = 1300" and for "[a.b]". toml++ 3.3 makes
// one nested table of each part and walks them recursively, so a key of a hundred thousand parts would overflow the
// stack.
std::size_t mostKeyParts(std::string_view text);

// Position of the first byte beyond ASCII that stands outside strings and comments, where TOML allows none (a
// byte-order mark at the beginning is passed over); npos where there is none. toml++ 3.3 runs into
// __builtin_unreachable for some of them, U+FB26 to U+FEFE.
std::size_t firstForeignByte(std::string_view text);

}  // namespace squat::cases
