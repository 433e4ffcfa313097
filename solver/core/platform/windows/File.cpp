#include "core/platform/File.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "core/platform/windows/Names.h"

namespace squat::platform {

namespace {

HANDLE handleOfFile(int number) { return reinterpret_cast<HANDLE>(::_get_osfhandle(number)); }

// Others may read, replace and remove the file meanwhile, as elsewhere. Folders can be opened too: state() tells.
int opened(const std::string& path, File::Access access) {
  const bool reads = access == File::Access::read;
  HANDLE file = ::CreateFileW(windows::wide(path).c_str(), reads ? GENERIC_READ : GENERIC_WRITE,
                              FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                              reads ? OPEN_EXISTING : CREATE_ALWAYS, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) return -1;
  return ::_open_osfhandle(reinterpret_cast<intptr_t>(file), _O_BINARY | _O_NOINHERIT | (reads ? _O_RDONLY : 0));
}

}  // namespace

File::File(const std::string& path, Access access) : number_(opened(path, access)) {
  if (number_ < 0) openingError_ = windows::lastError();
}

File::~File() {
  if (number_ >= 0) ::_close(number_);
}

File::State File::state(std::error_code& error) const {
  error.clear();
  if (::GetFileType(handleOfFile(number_)) != FILE_TYPE_DISK) return {};
  BY_HANDLE_FILE_INFORMATION found{};
  if (!::GetFileInformationByHandle(handleOfFile(number_), &found)) {
    error = windows::lastError();
    return {};
  }
  const bool isFolder = (found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  return {!isFolder, std::uint64_t{found.nFileSizeHigh} << 32U | found.nFileSizeLow};
}

std::size_t File::read(std::span<std::byte> into, std::error_code& error) {
  error.clear();
  DWORD count = 0;
  if (::ReadFile(handleOfFile(number_), into.data(), windows::pieceOf(into.size()), &count, nullptr)) return count;
  if (::GetLastError() != ERROR_BROKEN_PIPE) error = windows::lastError();
  return 0;
}

// Moves the place of read() as well, which nobody uses together with it.
bool File::readAt(std::uint64_t from, std::span<std::byte> into) const {
  for (std::size_t have = 0; have < into.size();) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(from + have);
    place.OffsetHigh = static_cast<DWORD>((from + have) >> 32U);
    DWORD count = 0;
    if (!::ReadFile(handleOfFile(number_), into.data() + have, windows::pieceOf(into.size() - have), &count, &place))
      return false;
    if (count == 0) return false;
    have += count;
  }
  return true;
}

std::error_code File::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    DWORD written = 0;
    if (!::WriteFile(handleOfFile(number_), bytes.data(), windows::pieceOf(bytes.size()), &written, nullptr))
      return windows::lastError();
    if (written == 0) return std::make_error_code(std::errc::no_space_on_device);
    bytes = bytes.subspan(written);
  }
  return {};
}

std::error_code File::flush() {
  return ::FlushFileBuffers(handleOfFile(number_)) ? std::error_code() : windows::lastError();
}

std::error_code File::close() {
  const int result = ::_close(number_);
  number_ = -1;
  return result == 0 ? std::error_code() : windows::lastError();
}

// A program that reads the file, or one that looks for viruses, may keep its name for a moment.
std::error_code rename(const std::string& from, const std::string& to) {
  constexpr int tries = 100;
  for (int attempt = 1;; ++attempt) {
    if (::MoveFileExW(windows::wide(from).c_str(), windows::wide(to).c_str(),
                      MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
      return {};
    const auto error = windows::lastError();
    const bool isInUse = error == std::errc::device_or_resource_busy || error == std::errc::permission_denied;
    if (!isInUse || attempt == tries) return error;
    ::Sleep(10);
  }
}

// rename() has written its change through; folders themselves cannot be flushed there.
void flushFolder(const std::string&) {}

bool mayRead(const std::string& path) { return ::_waccess(windows::wide(path).c_str(), 4) == 0; }

bool isLackOfRoom(std::error_code error) {
  return error == std::errc::no_space_on_device || error == std::errc::file_too_large;
}

}  // namespace squat::platform
