#include "core/platform/FileLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "core/platform/posix/System.h"

namespace squat::platform {
namespace {

// An owner that ends removes the file: who has waited for it between opening and locking holds a lock on nothing.
bool standsThere(int file, const std::string& path) {
  struct stat own {
  }, there{};
  return ::fstat(file, &own) == 0 && ::stat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
         own.st_dev == there.st_dev;
}

std::string textIn(int file) {
  std::array<char, 256> text{};  // more than a processName() (Process.h)
  const auto count = ::pread(file, text.data(), text.size(), 0);
  std::string owner(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  owner.erase(owner.find_last_not_of('\n') + 1);
  return owner;
}

// Who has the lock writes its name right after it has taken it.
std::string ownerIn(int file) {
  constexpr int looks = 100;
  for (int look = 0; look < looks; ++look) {
    if (auto owner = textIn(file); !owner.empty()) return owner;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return "another process";
}

}  // namespace

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  for (;;) {
    const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file < 0) return;
    isLocked_ = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    if (!isLocked_ && errno == EWOULDBLOCK) {
      other_ = ownerIn(file);
      ::close(file);
      return;
    }
    if (standsThere(file, path_)) {
      file_ = file;
      left_ = textIn(file);
      return;
    }
    ::close(file);
  }
}

FileLock::~FileLock() {
  if (file_ < 0) return;
  // On a file system that keeps locks to each machine, another one's text may stand there by now.
  const auto text = textIn(file_);
  if (text.empty() || text == written_) ::unlink(path_.c_str());
  ::close(file_);
}

bool FileLock::write(const std::string& text) {
  if (file_ < 0) return false;
  written_ = text.substr(0, text.find_last_not_of('\n') + 1);
  // The new text first, so that a reader never finds the file empty.
  const bool isWritten = ::pwrite(file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  return isWritten && ::ftruncate(file_, static_cast<off_t>(text.size())) == 0 && flushToDisk(file_) == 0;
}

}  // namespace squat::platform
