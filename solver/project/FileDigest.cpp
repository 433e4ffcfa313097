#include "project/FileDigest.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <system_error>

#include "case/ShortHash.h"
#include "core/platform/File.h"

namespace squat::project {
namespace {

constexpr std::uint64_t edge = 1 << 20;  // [bytes] that are read at the beginning and at the end

// False where the file has become shorter meanwhile, or cannot be read.
bool readFrom(const platform::File& file, std::uint64_t from, std::string& into) {
  return file.readAt(from, std::as_writable_bytes(std::span(into)));
}

}  // namespace

std::string fileDigest(const std::string& path) {
  const platform::File file(path, platform::File::Access::read);
  std::error_code error = file.openingError();
  if (error) return {};
  const auto state = file.state(error);
  if (error || !state.isRegular) return {};
  const std::uint64_t size = state.size, headTo = std::min(size, edge), tailFrom = std::max(headTo, size - headTo);
  std::string head(headTo, '\0'), tail(size - tailFrom, '\0');
  if (!readFrom(file, 0, head) || !readFrom(file, tailFrom, tail)) return {};
  return cases::shortHash(std::to_string(size) + ' ' + head + tail);
}

std::string changeOf(const std::string& path, const std::string& saved, const std::string& now) {
  if (saved.empty() || now.empty() || saved == now) return {};
  return path + " holds other values than when the project was saved";
}

}  // namespace squat::project
