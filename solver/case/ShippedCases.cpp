#include "case/ShippedCases.h"

#include <algorithm>
#include <cstdlib>

#include "case/ParameterTable.h"
#include "core/Errors.h"
#include "core/platform/ProgramPath.h"

namespace squat::cases {

namespace fs = std::filesystem;

namespace {

bool hasCases(const fs::path& folder) {
  std::error_code error;
  return !folder.empty() && fs::is_directory(folder / "cases", error);
}

// PREFIX/bin/squat -> PREFIX/share/squat-studio
fs::path besideProgram() {
  const auto program = platform::programPath();
  return program.empty() ? fs::path() : program.parent_path().parent_path() / "share" / "squat-studio";
}

// FOLDER/_solver.so -> FOLDER/resources, for the module of Python, whose program is the interpreter; of programs as
// above.
fs::path besideOwn() {
  const auto library = platform::ownLibrary();
  return library.empty() ? besideProgram() : library.parent_path() / "resources";
}

// What stands under the name of a case instead of a file; empty where nothing does.
std::string otherThan(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    return "cannot be accessed: " + error.message();
  if (fs::is_directory(status)) return "is a folder, not a case file";
  return fs::exists(status) ? "not a regular file" : "";
}

// The name with the smallest edit distance; empty where none is near.
std::string nearestCase(const std::string& name, const std::vector<std::string>& all) {
  if (name.size() > 100) return {};
  std::string nearest;
  int smallest = 2 + static_cast<int>(name.size()) / 4;  // farther than that is another word
  for (const auto& other : all)
    if (const int distance = editDistance(name, other); distance < smallest) nearest = other, smallest = distance;
  return nearest;
}

}  // namespace

fs::path resourcesFolder() {
  if (const char* named = std::getenv("SQUAT_RESOURCES"); named && *named) return named;
  for (const fs::path& folder : {besideOwn(), fs::path(SQUAT_SOURCE_RESOURCES), fs::path(SQUAT_INSTALLED_RESOURCES)})
    if (hasCases(folder)) return folder;
  return {};
}

std::vector<std::string> shippedCases() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(resourcesFolder() / "cases", error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path findCase(const std::string& nameOrPath) {
  std::error_code error;
  if (fs::is_regular_file(nameOrPath, error)) return nameOrPath;
  const bool isName = nameOrPath.find_first_of("/\\") == std::string::npos && !nameOrPath.empty();
  fs::path shipped = resourcesFolder() / "cases" / (nameOrPath + ".toml");
  if (isName && fs::is_regular_file(shipped, error)) return shipped;
  const auto other = otherThan(nameOrPath);
  const auto all = shippedCases();
  std::string names;
  for (const auto& name : all) names += (names.empty() ? "" : ", ") + name;
  const auto near = other.empty() ? nearestCase(fs::path(nameOrPath).stem().string(), all) : std::string();
  throw FileError(
      nameOrPath.empty() ? "''" : nameOrPath, "", other.empty() ? "no such case file or shipped case" : other,
      (near.empty() ? "" : "Did you mean " + near + "? ") +
          "Give the path of a case file or one of: " + (names.empty() ? "(no shipped cases found)" : names));
}

}  // namespace squat::cases
