// The source tree as text: files, their folders, their includes.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace squat::arch {

struct Include {
  std::string name;     // as between the quotes or brackets
  bool quoted = false;  // "own" or <system>
};

struct SourceFile {
  std::string path;    // from the top of the tree: "solver/case/CaseFile.h"
  std::string layer;   // "solver", "widgets", "app"
  std::string folder;  // "case", "scene"; "commands" for app/commands; empty for files of the layer itself
  int lines = 0;
  std::string text;  // as it stands in the file
  std::string code;  // without comments and without what stands between quotes
  std::vector<Include> includes;
};

// Every .h, .cpp and .inl of the given layers; throws where a layer is not there.
std::vector<SourceFile> readSources(const std::string& top, const std::vector<std::string>& layers);

// Source text with comments, strings and characters blanked out.
std::string withoutComments(const std::string& text);

}  // namespace squat::arch
