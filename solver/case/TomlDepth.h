// solver/case/TomlDepth.h - a guard in front of the TOML parser; internal to solver/case.
#pragma once

#include <cstddef>
#include <string_view>

namespace squat::cases {

// Largest number of parts that a key of the text has: 2 for "pad.stiffness = 1300" and for "[a.b]". toml++ 3.3 makes
// one nested table of each part and walks them recursively, so a key of a hundred thousand parts would overflow the
// stack.
std::size_t mostKeyParts(std::string_view text);

}  // namespace squat::cases
