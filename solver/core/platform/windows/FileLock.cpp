#include "core/platform/FileLock.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <array>
#include <chrono>
#include <thread>
#include <utility>

#include "core/platform/windows/Names.h"

namespace squat::platform {
namespace {

constexpr auto moment = std::chrono::milliseconds(2);
constexpr int looks = 100;

HANDLE fileOf(int number) { return reinterpret_cast<HANDLE>(::_get_osfhandle(number)); }

// Locks are of ranges and keep others from reading them: one byte far behind the text is locked.
OVERLAPPED lockedByte() {
  OVERLAPPED place{};
  place.OffsetHigh = 1U << 30U;
  return place;
}

// Below 0: it cannot be made. A file that its owner has just removed cannot be opened for a moment.
int openedLock(const std::string& path) {
  for (int look = 0; look < looks; ++look) {
    HANDLE file = ::CreateFileW(windows::wide(path).c_str(), GENERIC_READ | GENERIC_WRITE | DELETE,
                                FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_ALWAYS,
                                FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if (file != INVALID_HANDLE_VALUE)
      return ::_open_osfhandle(reinterpret_cast<intptr_t>(file), _O_BINARY | _O_NOINHERIT);
    if (::GetLastError() != ERROR_ACCESS_DENIED) return -1;
    std::this_thread::sleep_for(moment);
  }
  return -1;
}

// An owner that ends removes the file: who has waited for it between opening and locking holds a lock on nothing.
bool isStillThere(int file) {
  FILE_STANDARD_INFO state{};
  return ::GetFileInformationByHandleEx(fileOf(file), FileStandardInfo, &state, sizeof state) && !state.DeletePending &&
         state.NumberOfLinks > 0;
}

std::string textOf(int file) {
  std::array<char, 256> text{};  // more than a processName() (Process.h)
  OVERLAPPED beginning{};
  DWORD count = 0;
  if (!::ReadFile(fileOf(file), text.data(), text.size(), &count, &beginning)) count = 0;
  std::string owner(text.data(), count);
  owner.erase(owner.find_last_not_of('\n') + 1);
  return owner;
}

// Who has the lock writes its name right after it has taken it.
std::string ownerOf(int file) {
  for (int look = 0; look < looks; ++look) {
    if (auto owner = textOf(file); !owner.empty()) return owner;
    std::this_thread::sleep_for(moment);
  }
  return "another process";
}

}  // namespace

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  for (;;) {
    const int file = openedLock(path_);
    if (file < 0) return;
    auto place = lockedByte();
    isLocked_ = ::LockFileEx(fileOf(file), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) != 0;
    if (!isLocked_ && (::GetLastError() == ERROR_LOCK_VIOLATION || ::GetLastError() == ERROR_IO_PENDING)) {
      other_ = ownerOf(file);
      ::_close(file);
      return;
    }
    if (isStillThere(file)) {
      file_ = file;
      left_ = textOf(file);
      return;
    }
    ::_close(file);
  }
}

FileLock::~FileLock() {
  if (file_ < 0) return;
  // On a file system that keeps locks to each machine, another one's text may stand there by now.
  const auto text = textOf(file_);
  if (text.empty() || text == written_) {
    FILE_DISPOSITION_INFO removal{};
    removal.DeleteFile = TRUE;
    ::SetFileInformationByHandle(fileOf(file_), FileDispositionInfo, &removal, sizeof removal);
  }
  ::_close(file_);
}

bool FileLock::write(const std::string& text) {
  if (file_ < 0) return false;
  written_ = text.substr(0, text.find_last_not_of('\n') + 1);
  // The new text first, so that a reader never finds the file empty.
  OVERLAPPED beginning{};
  DWORD count = 0;
  const bool isWritten = ::WriteFile(fileOf(file_), text.data(), static_cast<DWORD>(text.size()), &count, &beginning) &&
                         count == text.size();
  return isWritten && ::_chsize_s(file_, static_cast<long long>(text.size())) == 0 &&
         ::FlushFileBuffers(fileOf(file_)) != 0;
}

}  // namespace squat::platform
