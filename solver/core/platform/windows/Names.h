// solver/core/platform/windows/Names.h - between the names of this program, which are UTF-8, and those of Windows; its
// sizes, and its errors as the others know them. For the sources of this folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace squat::platform::windows {

inline std::wstring wide(const std::string& text) { return std::filesystem::path(text).wstring(); }
inline std::string narrow(const std::wstring& text) { return std::filesystem::path(text).string(); }

// [bytes] of one call that reads or writes: sizes have 32 bits there.
inline std::uint32_t pieceOf(std::size_t bytes) {
  return static_cast<std::uint32_t>(std::min(bytes, std::size_t{1} << 30));
}

// Of the last call of the system, in the generic category.
std::error_code lastError();

}  // namespace squat::platform::windows
