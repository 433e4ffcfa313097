#include "arch/Page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

namespace squat::arch {

namespace fs = std::filesystem;

namespace {

std::string contentsOf(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void addNames(const std::string& text, const std::regex& pattern, const std::string& format,
              std::vector<std::string>& names) {
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
    names.push_back(found->format(format));
}

}  // namespace

std::vector<std::string> linesOf(const std::string& path) {
  const auto text = contentsOf(path);
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const auto to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

std::vector<PageCode> codeOf(const std::string& path) {
  static const std::regex span("`([^`]+)`");
  std::vector<PageCode> all;
  bool fenced = false;
  int number = 0;
  for (const auto& line : linesOf(path)) {
    ++number;
    if (line.rfind("```", 0) == 0) {
      fenced = !fenced;
    } else if (fenced || line.rfind("    ", 0) == 0) {
      all.push_back({fenced ? line : line.substr(4), true, number});
    } else {
      for (std::sregex_iterator found(line.begin(), line.end(), span), end; found != end; ++found)
        all.push_back({found->str(1), false, number});
    }
  }
  return all;
}

std::vector<std::string> pagesOf(const std::string& top) {
  std::vector<std::string> pages{top + "/README.md"};
  for (const auto& entry : fs::directory_iterator(top + "/resources/manual"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path().string());
  std::sort(pages.begin() + 1, pages.end());
  return pages;
}

std::vector<std::string> testNames(const std::string& top) {
  static const std::regex googleTest(R"(\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
  static const std::regex added(R"(\badd_test\(\s*NAME\s+([^\s)]+))"), call(R"(\bsquat_add_call\(\s*(\w+))");
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(top + "/tests")) {
    const auto& path = entry.path();
    if (path.extension() == ".cpp") addNames(contentsOf(path.string()), googleTest, "$1.$2", names);
    if (path.filename() != "CMakeLists.txt") continue;
    addNames(contentsOf(path.string()), added, "$1", names);
    addNames(contentsOf(path.string()), call, "Call.$1", names);
  }
  return names;
}

}  // namespace squat::arch
