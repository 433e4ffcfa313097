#include "pages/Program.h"

#include <filesystem>
#include <stdexcept>

#include "core/platform/CommandOutput.h"

namespace squat::pages {

namespace {

std::string helpOf(const std::string& path, const std::string& words) {
  const auto command = "'" + path + "' " + words + " --help 2>/dev/null";
  auto output = platform::outputOfCommand(command);
  if (!output.isStarted) throw std::runtime_error("cannot start " + command);
  if (!output.isDone) throw std::runtime_error(command + " failed");
  return output.text;
}

void addCalls(const std::string& path, const std::string& words, std::vector<std::pair<std::string, HelpText>>& calls) {
  const auto program = std::filesystem::path(path).filename().string();
  const auto help = helpFrom(helpOf(path, words));
  calls.emplace_back(words.empty() ? program : program + " " + words, help);
  for (const auto& command : help.of("Subcommands"))
    addCalls(path, words + (words.empty() ? "" : " ") + command.names.front(), calls);
}

}  // namespace

std::vector<std::pair<std::string, HelpText>> callsOf(const std::string& path) {
  std::vector<std::pair<std::string, HelpText>> calls;
  addCalls(path, "", calls);
  return calls;
}

}  // namespace squat::pages
