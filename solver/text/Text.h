// solver/text/Text.h - small helpers for plain text. Nothing here asks the locale.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace squat::text {

// Without the blanks on both sides: spaces, tabs and line ends where nothing else is said.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n");

// Letters A to Z as a to z; all others as they are.
std::string lowerCase(std::string_view text);

// The trimmed parts between the marks: one more than there are marks.
std::vector<std::string> split(std::string_view text, char mark);

// In quotes, cut after 40 bytes, control characters as "?": a field of a file as a message shows it.
std::string shown(std::string_view field);

}  // namespace squat::text
