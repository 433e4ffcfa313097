#include "project/FileDigest.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "case/ShortHash.h"
#include "core/FileDescriptor.h"

namespace squat::project {
namespace {

constexpr off_t edge = 1 << 20;  // [bytes] that are read at the beginning and at the end

// False where the file has become shorter meanwhile, or cannot be read.
bool readFrom(int file, off_t from, std::string& into) {
  for (std::size_t have = 0; have < into.size();) {
    const auto count = ::pread(file, into.data() + have, into.size() - have, from + static_cast<off_t>(have));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    have += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

std::string fileDigest(const std::string& path) {
  const FileDescriptor file(path, O_RDONLY | O_NONBLOCK);  // a named pipe must not hold the program
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const off_t size = status.st_size, tailFrom = std::max(std::min(size, edge), size - edge);
  std::string head(static_cast<std::size_t>(std::min(size, edge)), '\0');
  std::string tail(static_cast<std::size_t>(size - tailFrom), '\0');
  if (!readFrom(file.get(), 0, head) || !readFrom(file.get(), tailFrom, tail)) return {};
  return cases::shortHash(std::to_string(size) + ' ' + head + tail);
}

std::string changeOf(const std::string& path, const std::string& saved, const std::string& now) {
  if (saved.empty() || now.empty() || saved == now) return {};
  return path + " holds other values than when the project was saved";
}

}  // namespace squat::project
