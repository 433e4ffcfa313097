#include "pages/ManualPage.h"

#include <algorithm>

namespace squat::pages {

namespace {

// Text as man(7) takes it for text: a hyphen that can be copied, no escapes, no request at the beginning of a line.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  if (!safe.empty() && (safe.front() == '.' || safe.front() == '\'')) safe.insert(0, "\\&");
  return safe;
}

// "\fB\-o\fR, \fB\-\-output\fR \fIDIR\fR"
std::string termOf(const HelpEntry& entry) {
  std::vector<std::string> names;
  for (const auto& name : entry.names) names.push_back("\\fB" + escaped(name) + "\\fR");
  return joined(names, ", ") + (entry.value.empty() ? "" : " \\fI" + escaped(entry.value) + "\\fR");
}

std::string capitalisedTitle(const std::string& section) {
  if (section == "Positionals") return "ARGUMENTS";
  if (section == "Subcommands") return "COMMANDS";
  std::string title = section;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return title;
}

std::string lowered(std::string summary) {
  if (summary.size() > 1 && summary[1] >= 'a' && summary[1] <= 'z' && summary[0] >= 'A' && summary[0] <= 'Z')
    summary[0] = static_cast<char>(summary[0] - 'A' + 'a');
  if (summary.ends_with('.')) summary.pop_back();
  return summary;
}

}  // namespace

std::string pageName(const std::string& call) {
  std::string name = call;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string manualPage(const PageOf& page, const std::string& version) {
  const auto name = pageName(page.call);
  std::string text =
      ".TH \"" + capitalisedTitle(name) + "\" 1 \"\" \"" + version + "\" \"User commands\"\n.nh\n.ad l\n";
  text += ".SH NAME\n" + escaped(name) + " \\- " + escaped(lowered(page.help.summary)) + "\n";
  text += ".SH SYNOPSIS\n\\fB" + escaped(page.call) + "\\fR " + escaped(argumentsOf(page.help)) + "\n";
  for (const auto& section : page.help.sections) {
    text += ".SH " + capitalisedTitle(section.title) + "\n";
    for (const auto& entry : section.entries)
      text += ".TP\n" + termOf(entry) + "\n" + escaped(sentenceOf(entry)) + "\n";
  }
  std::string notes, exits;
  for (const auto& line : page.help.footer)
    (line.starts_with("Exit code") ? exits : notes) += escaped(line) + "\n.br\n";
  if (!notes.empty()) text += ".SH NOTES\n" + notes;
  if (!exits.empty()) text += ".SH EXIT STATUS\n" + exits;
  std::vector<std::string> others;
  for (const auto& call : page.seeAlso) others.push_back("\\fB" + escaped(pageName(call)) + "\\fR(1)");
  if (!others.empty()) text += ".SH SEE ALSO\n" + joined(others, ", ") + "\n";
  return text;
}

}  // namespace squat::pages
