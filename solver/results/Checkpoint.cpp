#include "results/Checkpoint.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/Errors.h"
#include "results/StateFile.h"

namespace squat::results {

namespace {

constexpr StateKind kKind{"squat-checkpoint", kCheckpointVersion, "a checkpoint",
                          "start the run again without --resume"};

}  // namespace

void writeCheckpoint(const std::string& path, ArrayTree state) {
  writeState(path, std::move(state), kKind, Previous::kept);
}

std::optional<ArrayTree> readCheckpoint(const std::string& path, bool* usedPrevious) {
  const auto previous = path + ".previous";
  std::error_code ignored;
  const bool hasPrevious = std::filesystem::exists(previous, ignored);
  if (usedPrevious) *usedPrevious = false;
  if (std::filesystem::exists(path, ignored)) {
    try {
      return readState(path, kKind);
    } catch (const FileError&) {
      if (!hasPrevious) throw;
    }
  } else if (!hasPrevious) {
    return std::nullopt;
  }
  if (usedPrevious) *usedPrevious = true;
  return readState(previous, kKind);
}

void removeCheckpoint(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  std::filesystem::remove(path + ".previous", ignored);
}

}  // namespace squat::results
