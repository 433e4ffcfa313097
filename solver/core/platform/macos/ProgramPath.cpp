#include "core/platform/ProgramPath.h"

#include <dlfcn.h>
#include <mach-o/dyld.h>

#include <cstdint>
#include <string>
#include <system_error>

namespace squat::platform {

namespace fs = std::filesystem;

namespace {

// Something that lies in the same file as this code, whatever other libraries hold.
constexpr char here = 0;

}  // namespace

fs::path programPath() {
  std::uint32_t size = 0;
  ::_NSGetExecutablePath(nullptr, &size);
  std::string path(size, '\0');
  if (::_NSGetExecutablePath(path.data(), &size) != 0) return {};
  std::error_code error;
  fs::path program = fs::canonical(path.c_str(), error);
  return error ? fs::path() : program;
}

fs::path ownLibrary() {
  Dl_info place{};
  if (::dladdr(&here, &place) == 0 || !place.dli_fname) return {};
  fs::path file = place.dli_fname;
  return file.extension() == ".so" || file.extension() == ".dylib" ? file : fs::path();
}

}  // namespace squat::platform
