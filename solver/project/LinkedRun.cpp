#include "project/LinkedRun.h"

#include <filesystem>

#include "results/ResultFile.h"

namespace squat::project {

std::string changeOf(const Entry& entry, const signals::Record& record) {
  if (entry.digest.empty() || entry.digest == recordDigest(record)) return {};
  return entry.path + " holds other values than when the project was saved";
}

LinkedRun openRun(const Entry& entry) {
  try {
    auto result = std::make_shared<results::RunResult>(results::readResult(entry.path));
    if (result->stem.empty()) result->stem = std::filesystem::path(entry.path).stem().string();
    const std::string problem = changeOf(entry, *result);
    return {std::move(result), problem};
  } catch (const std::exception& error) {
    return {nullptr, error.what()};
  }
}

}  // namespace squat::project
