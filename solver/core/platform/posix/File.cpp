#include "core/platform/File.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "core/platform/posix/System.h"

namespace squat::platform {

namespace {

std::error_code lastError() { return {errno, std::generic_category()}; }

int flagsFor(File::Access access) {
  return (access == File::Access::read ? O_RDONLY | O_NONBLOCK : O_WRONLY | O_CREAT | O_TRUNC) | O_CLOEXEC;
}

}  // namespace

File::File(const std::string& path, Access access) : number_(::open(path.c_str(), flagsFor(access), 0666)) {
  if (number_ < 0) openingError_ = lastError();
}

File::~File() {
  if (number_ >= 0) ::close(number_);
}

File::State File::state(std::error_code& error) const {
  struct stat found {};
  error = ::fstat(number_, &found) == 0 ? std::error_code() : lastError();
  if (error) return {};
  return {S_ISREG(found.st_mode), static_cast<std::uint64_t>(found.st_size)};
}

std::size_t File::read(std::span<std::byte> into, std::error_code& error) {
  error.clear();
  for (;;) {
    const auto count = ::read(number_, into.data(), into.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EINTR) continue;
    error = lastError();
    return 0;
  }
}

bool File::readAt(std::uint64_t from, std::span<std::byte> into) const {
  for (std::size_t have = 0; have < into.size();) {
    const auto count = ::pread(number_, into.data() + have, into.size() - have, static_cast<off_t>(from + have));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    have += static_cast<std::size_t>(count);
  }
  return true;
}

std::error_code File::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(number_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return lastError();
    if (written == 0) return std::make_error_code(std::errc::no_space_on_device);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

std::error_code File::flush() { return flushToDisk(number_) == 0 ? std::error_code() : lastError(); }

std::error_code File::close() {
  const int result = ::close(number_);
  number_ = -1;
  return result == 0 ? std::error_code() : lastError();
}

std::error_code rename(const std::string& from, const std::string& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  return error;
}

void flushFolder(const std::string& folder) {
  const int number = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (number < 0) return;
  flushToDisk(number);
  ::close(number);
}

bool mayRead(const std::string& path) { return ::access(path.c_str(), R_OK) == 0; }

bool isLackOfRoom(std::error_code error) {
  return error == std::errc::no_space_on_device || error == std::errc::file_too_large ||
         error == std::error_code(EDQUOT, std::generic_category());
}

}  // namespace squat::platform
