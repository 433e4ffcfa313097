#include "arch/SourceTree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace squat::arch {

namespace fs = std::filesystem;

std::string withoutComments(const std::string& text) {
  enum class In { code, lineComment, blockComment, quotes, character } in = In::code;
  std::string code;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char now = text[i];
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    switch (in) {
      case In::code:
        if (now == '/' && next == '/') in = In::lineComment;
        if (now == '/' && next == '*') in = In::blockComment;
        if (now == '"') in = In::quotes;
        // A quote between digits parts thousands (1'000) and opens nothing.
        if (now == '\'' && !(i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])))) in = In::character;
        if (in == In::code) code += now;
        break;
      case In::lineComment:
        if (now == '\n') {
          in = In::code;
          code += now;
        }
        break;
      case In::blockComment:
        if (now == '*' && next == '/') {
          in = In::code;
          ++i;
        }
        break;
      case In::quotes:
      case In::character:
        if (now == '\\')
          ++i;
        else if (now == (in == In::quotes ? '"' : '\''))
          in = In::code;
        break;
    }
  }
  return code;
}

namespace {

SourceFile readSource(const fs::path& top, const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream buffer;
  buffer << stream.rdbuf();

  SourceFile file;
  file.text = buffer.str();
  const auto relative = path.lexically_relative(top);
  file.path = relative.generic_string();
  auto part = relative.begin();
  file.layer = part->string();
  ++part;
  if (std::next(part) != relative.end()) file.folder = part->string();
  file.lines = static_cast<int>(std::count(file.text.begin(), file.text.end(), '\n'));
  file.code = withoutComments(file.text);

  static const std::regex pattern(R"re(^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"])re");
  std::istringstream lines(file.text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) file.includes.push_back({match[2], match[1] == "\""});
  }
  return file;
}

}  // namespace

std::vector<SourceFile> readSources(const std::string& top, const std::vector<std::string>& layers) {
  std::vector<SourceFile> files;
  for (const auto& layer : layers)
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(top) / layer)) {
      const auto ending = entry.path().extension();
      if (ending == ".h" || ending == ".cpp" || ending == ".inl") files.push_back(readSource(top, entry.path()));
    }
  return files;
}

}  // namespace squat::arch
