#include "pages/CommandPage.h"

#include "pages/Markdown.h"
#include "text/HeadingAnchor.h"

namespace squat::pages {

namespace {

constexpr const char* kCommandsIntroduction = R"(# Commands and options

What the programs print for `--help`; this page is written from that when they are built. `squat help run` prints one
section, `man squat-run` shows it where the program is installed.
)";

// "`-o`, `--output` DIR"; a command with a link to its own section.
std::string nameCell(const std::string& call, const std::string& section, const HelpEntry& entry) {
  if (section == "Subcommands") {
    const auto command = call + " " + entry.names.front();
    return "[" + codeText(command) + "](#" + text::headingAnchor(command) + ")";
  }
  std::vector<std::string> names;
  for (const auto& name : entry.names) names.push_back(codeText(name));
  return joined(names, ", ") + (entry.value.empty() ? "" : " " + plainText(entry.value));
}

std::string titleOf(const std::string& section) {
  if (section == "Positionals") return "argument";
  if (section == "Subcommands") return "command";
  std::string title = section;  // "Options", "Figures": one a row
  if (title.ends_with('s')) title.pop_back();
  title.front() = static_cast<char>(title.front() | 0x20);
  return title;
}

std::string sectionOf(const std::string& call, const HelpText& help) {
  std::string text =
      "\n## " + call + "\n\n" + plainText(help.summary) + "\n\n    " + call + " " + argumentsOf(help) + "\n";
  for (const auto& section : help.sections) {
    text += "\n" + tableHead({titleOf(section.title), "what it does"});
    for (const auto& entry : section.entries)
      text += tableRow({nameCell(call, section.title, entry), plainText(sentenceOf(entry))});
  }
  for (const auto& line : help.footer) text += "\n" + plainText(line) + "\n";
  return text;
}

}  // namespace

std::string commandPage(const std::vector<std::pair<std::string, HelpText>>& calls) {
  std::string text = kCommandsIntroduction;
  for (const auto& [call, help] : calls) text += sectionOf(call, help);
  return text;
}

}  // namespace squat::pages
