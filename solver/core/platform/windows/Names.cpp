#include "core/platform/windows/Names.h"

#include <windows.h>

#include <cerrno>
#include <cstddef>
#include <cwchar>
#include <span>

namespace squat::platform::windows {

namespace {

int numberOf(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_INVALID_DRIVE:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_PRIVILEGE_NOT_HELD:
      return EACCES;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      return EBUSY;
    case ERROR_ALREADY_EXISTS:
    case ERROR_FILE_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
    case ERROR_COMMITMENT_LIMIT:
      return ENOMEM;
    case ERROR_BROKEN_PIPE:
    case ERROR_NO_DATA:
      return EPIPE;
    default:
      return EIO;
  }
}

}  // namespace

std::error_code lastError() { return {numberOf(::GetLastError()), std::generic_category()}; }

namespace {

constexpr wchar_t unknown = 0xfffd;

// Bytes that the character has which begins so; 0: none does.
std::size_t lengthFrom(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

// Of whole characters; above 0x10ffff: damaged.
char32_t characterOf(std::span<const char> bytes) {
  constexpr char32_t damaged = 0xffffffff;
  const auto first = static_cast<unsigned char>(bytes[0]);
  char32_t character = bytes.size() == 1 ? first : first & (0x7fU >> bytes.size());
  for (const char each : bytes.subspan(1)) {
    const auto byte = static_cast<unsigned char>(each);
    if ((byte & 0xc0U) != 0x80) return damaged;
    character = character << 6U | (byte & 0x3fU);
  }
  return character;
}

}  // namespace

}  // namespace squat::platform::windows

// std::filesystem::path widens a narrow string by the C library's mbrtowc(), which knows the code pages of one and two
// bytes and would take "ä" for two letters. The linker puts this in its place (--wrap; CMakeLists.txt): UTF-8, whatever
// the locale. A character of two wide ones comes in two calls, three bytes and one; meanwhile the second one is the
// state.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* into, const char* bytes, std::size_t count, std::mbstate_t* state) {
  using namespace squat::platform::windows;
  wchar_t ignored = 0;
  wchar_t& wide = into ? *into : ignored;
  if (!bytes || count == 0) return bytes ? static_cast<std::size_t>(-2) : 0;
  if (state && *state != 0) {
    wide = static_cast<wchar_t>(*state);
    *state = 0;
    return 1;
  }
  const std::size_t length = lengthFrom(static_cast<unsigned char>(*bytes));
  const char32_t character = length > 0 && length <= count ? characterOf({bytes, length}) : 0xffffffff;
  if (character > 0x10ffff) {
    wide = unknown;
    return 1;
  }
  wide = static_cast<wchar_t>(character);
  if (character < 0x10000) return character == 0 ? 0 : length;
  wide = static_cast<wchar_t>(0xd800 + ((character - 0x10000) >> 10U));
  if (state) *state = static_cast<std::mbstate_t>(0xdc00 + ((character - 0x10000) & 0x3ffU));
  return 3;
}
