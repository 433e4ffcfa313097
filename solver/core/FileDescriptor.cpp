#include "core/FileDescriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <vector>

namespace squat {

namespace {
constexpr const char* kPart = ".part-";
}

FileDescriptor::FileDescriptor(const std::string& path, int flags)
    : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::close(number_);
}

int FileDescriptor::closeNow() {
  const int result = ::close(number_);
  number_ = -1;
  return result == 0 ? 0 : errno;
}

FileSizeSignalBlocked::FileSizeSignalBlocked() {
  sigemptyset(&set_);
  sigaddset(&set_, SIGXFSZ);
  ::pthread_sigmask(SIG_BLOCK, &set_, &before_);
}

FileSizeSignalBlocked::~FileSizeSignalBlocked() {
  if (!sigismember(&before_, SIGXFSZ)) {
    const timespec now{};
    while (::sigtimedwait(&set_, nullptr, &now) > 0) {
    }
  }
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

std::string partName(const std::string& path) { return path + kPart + std::to_string(::getpid()); }

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
    if (::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) left.push_back(entry.path());
  }
  for (const auto& each : left) fs::remove_all(each, ignored);
}

}  // namespace squat
