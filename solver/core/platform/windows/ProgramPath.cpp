#include "core/platform/ProgramPath.h"

#include <windows.h>

#include <string>

namespace squat::platform {

namespace fs = std::filesystem;

namespace {

// Something that lies in the same file as this code, whatever other libraries hold.
constexpr char here = 0;

fs::path pathOf(HMODULE module) {
  constexpr DWORD longest = 1U << 15U;  // of a path there, in characters
  std::wstring text(longest, L'\0');
  text.resize(::GetModuleFileNameW(module, text.data(), longest));
  return text;
}

}  // namespace

fs::path programPath() { return pathOf(nullptr); }

fs::path ownLibrary() {
  HMODULE module = nullptr;
  constexpr DWORD flags = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  if (!::GetModuleHandleExW(flags, reinterpret_cast<LPCWSTR>(&here), &module)) return {};
  return module == ::GetModuleHandleW(nullptr) ? fs::path() : pathOf(module);
}

}  // namespace squat::platform
