#include "pages/Completion.h"

#include <algorithm>

namespace squat::pages {

namespace {

// The frame around the tables. $path is the call so far ("squat run"); a list is completed behind its last comma.
constexpr const char* kCompletionScript = R"(# Written from the programs' own help when they were built.
_@() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local path="PROGRAM" options="" words="" files=yes list="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$path ${COMP_WORDS[i]}" in
)";
constexpr const char* kEnd = R"(    *) [[ $current == -* ]] && words=$options files= ;;
  esac
  local before=""
  [[ $list && $current == *,* ]] && before=${current%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${current#"$before"}"
    [[ ! $files ]] || compgen -f -- "$current")
}
complete -o filenames -F _@ PROGRAM
)";

std::string replaced(std::string text, const std::string& program) {
  std::string function = program;
  std::replace(function.begin(), function.end(), '-', '_');
  for (auto at = text.find('@'); at != std::string::npos; at = text.find('@')) text.replace(at, 1, function);
  for (auto at = text.find("PROGRAM"); at != std::string::npos; at = text.find("PROGRAM")) text.replace(at, 7, program);
  return text;
}

std::vector<std::string> namesOf(const std::vector<HelpEntry>& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.insert(names.end(), entry.names.begin(), entry.names.end());
  return names;
}

// A case may be a file as well as one of the names that the help lists.
bool takesFiles(const HelpEntry& entry) { return entry.choices.empty() || entry.value == "CASE"; }

// What stands for the first argument of a call: its commands, or what its arguments may be.
std::string callRow(const std::string& call, const HelpText& help) {
  auto words = namesOf(help.of("Subcommands"));
  const bool commands = !words.empty();
  for (const char* title : {"Positionals", "Arguments"})
    for (const auto& entry : help.of(title)) words.insert(words.end(), entry.choices.begin(), entry.choices.end());
  return "    \"" + call + "\") options=\"" + joined(namesOf(help.of("Options"))) + "\" words=\"" + joined(words) +
         "\" files=" + (commands ? "" : "yes") + " ;;\n";
}

// What stands behind an option that takes a value. --figures lists its values in a section of its own.
std::string valueRow(const std::string& call, const HelpText& help, const HelpEntry& entry) {
  if (entry.value.empty() && entry.choices.empty()) return {};
  std::string patterns;
  auto choices = entry.choices;
  for (const auto& name : entry.names) {
    patterns += (patterns.empty() ? "" : " | ") + ("\"" + call + " " + name + "\"");
    if (name == "--figures") choices = namesOf(help.of("Figures"));
  }
  const bool files = choices.empty() || takesFiles(entry);
  return "    " + patterns + ") words=\"" + joined(choices) + "\" files=" + (files && !entry.isList ? "yes" : "") +
         " list=" + (entry.isList ? "yes" : "") + " ;;\n";
}

}  // namespace

std::string completion(const std::vector<std::pair<std::string, HelpText>>& calls) {
  const auto& program = calls.front().first;
  std::string text = replaced(kCompletionScript, program);
  for (std::size_t i = 1; i < calls.size(); ++i)
    text += "      \"" + calls[i].first + "\") path=\"" + calls[i].first + "\" ;;\n";
  text += "      *) ;;\n    esac\n  done\n  case $path in\n";
  for (const auto& [call, help] : calls) text += callRow(call, help);
  text += "  esac\n  case \"$path $previous\" in\n";
  for (const auto& [call, help] : calls)
    for (const auto& entry : help.of("Options")) text += valueRow(call, help, entry);
  return text + replaced(kEnd, program);
}

}  // namespace squat::pages
