#include "pages/HelpText.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "text/Text.h"

namespace squat::pages {

namespace {

std::string trimmed(const std::string& text) { return std::string(text::trimmed(text)); }

// "sse2, avx2 or avx512" -> three words; nothing where one of the parts is more than a word.
std::vector<std::string> wordsOf(std::string list) {
  static const std::regex word("[a-z0-9][a-z0-9_-]*");
  list = std::regex_replace(list, std::regex(" or | and "), ",");
  auto parts = text::split(list, ',');
  const bool areWords =
      std::all_of(parts.begin(), parts.end(), [](const std::string& part) { return std::regex_match(part, word); });
  return areWords && parts.size() > 1 ? parts : std::vector<std::string>();
}

// The choices that a sentence lists: behind its last colon, or from its beginning. What stands in brackets is about
// them: "png, svg, pdf (default: all)".
std::vector<std::string> choicesIn(const std::string& text) {
  auto sentence = std::regex_replace(text, std::regex(R"(\([^)]*\))"), "");
  if (const auto colon = sentence.rfind(": "); colon != std::string::npos) sentence.erase(0, colon + 2);
  sentence = trimmed(sentence);
  if (sentence.ends_with('.')) sentence.pop_back();
  return wordsOf(sentence);
}

// Takes "NAME: words" off the end of the printed names, as CLI11 appends it: "Excludes: --vary --sample".
std::string takeNote(std::string& names, const std::string& title) {
  std::smatch found;
  if (!std::regex_search(names, found, std::regex("\\s*" + title + ":((?: -[\\w-]+)+)"))) return {};
  auto note = trimmed(found.str(1));
  names = found.prefix().str() + found.suffix().str();
  return note;
}

// "--threads N:INT in [1 - 1024]", "-o,--output DIR", "--screenshot <OUT.png>", "case CASE REQUIRED"
HelpEntry entryFrom(std::string names, const std::string& text) {
  HelpEntry entry;
  entry.text = text;
  entry.excludes = takeNote(names, "Excludes");
  entry.needs = takeNote(names, "Needs");
  names = trimmed(std::regex_replace(names, std::regex("( REQUIRED\\b| \\.\\.\\.)"), ""));
  std::smatch found;
  if (std::regex_search(names, found, std::regex(R"(:\{([^}]*)\}$)"))) {
    entry.choices = text::split(found.str(1), ',');
    names = found.prefix();
  } else if (std::regex_search(names, found, std::regex(R"(:[A-Z]+ in \[(\S+) - (\S+)\]$)"))) {
    entry.range = found.str(1) + " to " + found.str(2);
    names = found.prefix();
  } else if (std::regex_search(names, found, std::regex(R"(:(\S+ to \S+)$)"))) {
    entry.range = found.str(1);
    names = found.prefix();
  }
  names = std::regex_replace(names, std::regex(", -"), ",-");
  const auto blank = names.find(' ');
  entry.names = text::split(names.substr(0, blank), ',');
  if (blank != std::string::npos) entry.value = trimmed(names.substr(blank));
  entry.value = std::regex_replace(entry.value, std::regex("[<>]"), "");
  entry.isList = entry.value.ends_with(",...");
  return entry;
}

struct Row {
  std::string names, text;
};

std::size_t indentOf(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

// The column of the sentences: behind the first gap of two blanks, or where a line goes on.
std::size_t columnOf(const std::vector<std::string>& lines) {
  for (const auto& line : lines) {
    if (indentOf(line) > 2) return indentOf(line);
    if (const auto gap = line.find("  ", 2); gap != std::string::npos) return line.find_first_not_of(' ', gap);
  }
  return std::string::npos;
}

std::vector<HelpEntry> entriesFrom(const std::vector<std::string>& lines) {
  const auto column = columnOf(lines);
  std::vector<Row> rows;
  for (const auto& line : lines) {
    if (indentOf(line) > 2 && !rows.empty()) {
      rows.back().text += (rows.back().text.empty() ? "" : " ") + trimmed(line);
      continue;
    }
    const bool hasBoth = column != std::string::npos && line.size() > column && line[column - 1] == ' ';
    rows.push_back({trimmed(hasBoth ? line.substr(0, column) : line), hasBoth ? trimmed(line.substr(column)) : ""});
  }
  std::vector<HelpEntry> entries;
  for (const auto& row : rows) {
    entries.push_back(entryFrom(row.names, row.text));
    if (auto& entry = entries.back(); !entry.value.empty() && entry.choices.empty())
      entry.choices = choicesIn(row.text);
  }
  return entries;
}

}  // namespace

const std::vector<HelpEntry>& HelpText::of(const std::string& title) const {
  static const std::vector<HelpEntry> none;
  for (const auto& section : sections)
    if (section.title == title) return section.entries;
  return none;
}

std::string sentenceOf(const HelpEntry& entry) {
  std::string text = entry.text;
  const bool listed = std::all_of(entry.choices.begin(), entry.choices.end(),
                                  [&](const std::string& choice) { return text.find(choice) != std::string::npos; });
  const auto add = [&](const std::string& words) {
    text += (text.empty() || text.ends_with('.') ? " " : ". ") + words;
  };
  if (!listed) add("One of: " + joined(entry.choices, ", "));
  if (!entry.range.empty()) add("Range: " + entry.range);
  if (!entry.needs.empty()) add("Needs: " + entry.needs);
  if (!entry.excludes.empty()) add("Not with: " + entry.excludes);
  return text;
}

std::string argumentsOf(const HelpText& help) {
  const auto at = help.usage.find('[');
  return at == std::string::npos ? std::string() : help.usage.substr(at);
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string all;
  for (const auto& part : parts) all += (all.empty() ? "" : between) + part;
  return all;
}

HelpText helpFrom(const std::string& text) {
  HelpText help;
  std::vector<std::vector<std::string>> lines;  // of each section
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (trimmed(line).empty()) continue;
    if (line.starts_with("Usage: ")) {
      help.usage = line.substr(7);
    } else if (line.front() != ' ' && line.back() == ':') {
      help.sections.push_back({line.substr(0, line.size() - 1), {}});
      lines.emplace_back();
    } else if (line.front() == ' ' && !lines.empty()) {
      lines.back().push_back(line);
    } else if (help.sections.empty()) {
      help.summary += (help.summary.empty() ? "" : " ") + trimmed(line);
    } else {
      help.footer.push_back(line);
    }
  }
  if (help.usage.empty()) throw std::runtime_error("a help without \"Usage:\": " + text.substr(0, 200));
  for (std::size_t i = 0; i < lines.size(); ++i) help.sections[i].entries = entriesFrom(lines[i]);
  return help;
}

}  // namespace squat::pages
