#include "core/FolderLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "core/Errors.h"

namespace squat {
namespace {

// An owner that ends removes the file: who has waited for it between opening and locking holds a lock on nothing.
bool standsThere(int file, const std::string& path) {
  struct stat own {
  }, there{};
  return ::fstat(file, &own) == 0 && ::stat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
         own.st_dev == there.st_dev;
}

std::string ownerIn(int file) {
  std::array<char, 256> text{};
  const auto count = ::pread(file, text.data(), text.size(), 0);
  std::string owner(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  owner.erase(owner.find_last_not_of('\n') + 1);
  return owner.empty() ? "another process" : owner;
}

std::string nameOfThisProcess(const std::string& owner) {
  std::array<char, 128> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = 0;
  // The whole fits into what ownerIn() reads.
  return owner.substr(0, 100) + " (process " + std::to_string(::getpid()) + " on " +
         std::string(host.data()).substr(0, 64) + ")";
}

}  // namespace

FolderLock::FolderLock(const std::string& folder, const std::string& owner) : path_(folder + "/.squat-lock") {
  for (;;) {
    const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file < 0) return;
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      const bool taken = errno == EWOULDBLOCK;
      const std::string other = taken ? ownerIn(file) : std::string();
      ::close(file);
      if (!taken) return;
      throw CaseError({{"-o", folder, "a folder that no other run is writing to",
                        "In use by " + other + ": wait until it has ended, or choose another folder"}});
    }
    if (standsThere(file, path_)) {
      file_ = file;
      break;
    }
    ::close(file);
  }
  const std::string name = nameOfThisProcess(owner) + "\n";
  if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, name.data(), name.size(), 0) < 0) {
    // A full disk: the lock holds, without a name.
  }
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  ::unlink(path_.c_str());
  ::close(file_);
}

}  // namespace squat
