#include "commands/OutputFolder.h"

#include <system_error>

#include "core/DurableFile.h"

namespace squat::commands {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& folder) {
  std::error_code ignored;
  auto path = fs::absolute(folder, ignored).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "out/" is "out"
  for (; path.has_relative_path() && !fs::exists(path, ignored); path = path.parent_path()) made_.push_back(path);
  makeFolder(folder);
}

OutputFolder::~OutputFolder() {
  // fs::remove refuses a folder that holds something, and then its parents stay as well.
  std::error_code failure;
  for (const auto& path : made_)
    if (!fs::remove(path, failure) || failure) return;
}

}  // namespace squat::commands
