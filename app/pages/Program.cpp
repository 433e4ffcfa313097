#include "pages/Program.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace squat::pages {

namespace {

std::string helpOf(const std::string& path, const std::string& words) {
  const auto command = "'" + path + "' " + words + " --help 2>/dev/null";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start " + command);
  std::string text;
  std::array<char, 4096> piece{};
  while (const auto size = std::fread(piece.data(), 1, piece.size(), pipe)) text.append(piece.data(), size);
  if (::pclose(pipe) != 0) throw std::runtime_error(command + " failed");
  return text;
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
