#include "core/PartFile.h"

#include <charconv>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/platform/Process.h"

namespace squat {

namespace {
constexpr const char* kPart = ".part-";
}

std::string partName(const std::string& path) { return path + kPart + std::to_string(platform::processNumber()); }

void removeLeftOvers(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(path).parent_path();
  const std::string prefix = fs::path(path).filename().string() + kPart;
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    long process = 0;
    const auto* last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data() + prefix.size(), last, process);
    if (error != std::errc() || end != last || process <= 0) continue;
    if (!platform::isRunning(process)) left.push_back(entry.path());
  }
  for (const auto& each : left) fs::remove_all(each, ignored);
}

}  // namespace squat
