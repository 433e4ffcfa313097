#include "pages/Markdown.h"

#include <string_view>

#include "pages/HelpText.h"

namespace squat::pages {

std::string plainText(const std::string& text) {
  constexpr std::string_view special = "\\`*<>|[]#~&";
  std::string safe;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

std::string codeText(const std::string& text) { return "`" + text + "`"; }

std::string tableRow(const std::vector<std::string>& cells) { return "| " + joined(cells, " | ") + " |\n"; }

std::string tableHead(const std::vector<std::string>& names) {
  std::string line = "|";
  for (std::size_t i = 0; i < names.size(); ++i) line += "---|";
  return tableRow(names) + line + "\n";
}

}  // namespace squat::pages
