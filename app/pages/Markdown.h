// app/pages/Markdown.h - pieces of Markdown, as GitHub reads it.
#pragma once

#include <string>
#include <vector>

namespace squat::pages {

// Plain text that stays plain: signs with a meaning of their own get a backslash; a line end becomes a blank.
std::string plainText(const std::string& text);

// `text` as code. It has no backtick and no bar: readers of Markdown differ about bars in the code of a table.
std::string codeText(const std::string& text);

// "| a | b |\n". Cells are Markdown already.
std::string tableRow(const std::vector<std::string>& cells);
// The row of names with the line below it.
std::string tableHead(const std::vector<std::string>& names);

}  // namespace squat::pages
