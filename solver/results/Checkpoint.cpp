#include "results/Checkpoint.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/TreeStream.h"

namespace squat::results {

namespace {

constexpr std::size_t kLargestCheckpoint = std::size_t{2} << 30;  // [bytes]; the paper's mesh needs about 0.1e9
constexpr const char* kSchema = "squat-checkpoint";

ArrayTree readOne(const std::string& path) {
  const auto text = readWholeFile(path, kLargestCheckpoint);
  auto state = decodeTree(sourceOf(std::as_bytes(std::span(text))), path, kLargestCheckpoint);
  if (textAttribute(state.attributes, "schema") != kSchema)
    throw FileError(path, "attribute schema", "is not a checkpoint", "Name a checkpoint of this program");
  const double version = numberAttribute(state.attributes, "schema_version", -1);
  if (!(version >= 1)) throw FileError(path, "attribute schema_version", "is missing or wrong");
  if (version > kCheckpointVersion)
    throw FileError(path, "attribute schema_version", "was written by a newer version of the program",
                    "Use that version, or start the run anew without --resume");
  if (const auto array = firstNotFinite(state); !array.empty())
    throw FileError(path, array, "holds a value that is not a number", "Start the run anew without --resume");
  return state;
}

}  // namespace

void writeCheckpoint(const std::string& path, ArrayTree state) {
  if (const auto array = firstNotFinite(state); !array.empty())
    throw FileError(path, array, "not written: the state holds a value that is not a number");
  setAttribute(state.attributes, "schema", std::string(kSchema));
  setAttribute(state.attributes, "schema_version", std::int64_t{kCheckpointVersion});
  const auto bytes = encodeTree(state);
  const auto verify = [&](const std::string& part) {
    const auto back = readWholeFile(part, kLargestCheckpoint);
    if (!std::ranges::equal(std::as_bytes(std::span(back)), bytes))
      throw FileError(path, "", "did not read back as it was written", "Check the disk");
  };
  writeDurably(path, bytes, verify, Previous::kept);
}

std::optional<ArrayTree> readCheckpoint(const std::string& path, bool* usedPrevious) {
  const auto previous = path + ".previous";
  std::error_code ignored;
  const bool hasPrevious = std::filesystem::exists(previous, ignored);
  if (usedPrevious) *usedPrevious = false;
  if (std::filesystem::exists(path, ignored)) {
    try {
      return readOne(path);
    } catch (const FileError&) {
      if (!hasPrevious) throw;
    }
  } else if (!hasPrevious) {
    return std::nullopt;
  }
  if (usedPrevious) *usedPrevious = true;
  return readOne(previous);
}

void removeCheckpoint(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  std::filesystem::remove(path + ".previous", ignored);
}

}  // namespace squat::results
