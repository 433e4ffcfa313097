// A page of the documentation: what stands in it as code, and the names of the tests that it may speak of.
#pragma once

#include <string>
#include <vector>

namespace squat::arch {

struct PageCode {
  std::string text;      // one line of an indented or fenced block, or what stands between backticks
  bool isBlock = false;  // of a block
  int line = 0;          // of the page
};

// In the order of the page. Throws where the file cannot be read.
std::vector<PageCode> codeOf(const std::string& path);

// README.md and every page of resources/manual, with their whole path.
std::vector<std::string> pagesOf(const std::string& top);

// "Suite.Name" of every test in the tree: those of GoogleTest, and those that the CMake files add by name. A variable
// in such a name stands as it is written.
std::vector<std::string> testNames(const std::string& top);

std::vector<std::string> linesOf(const std::string& path);

}  // namespace squat::arch
