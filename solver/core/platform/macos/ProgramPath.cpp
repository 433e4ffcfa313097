#include "core/platform/ProgramPath.h"

#include <mach-o/dyld.h>

#include <cstdint>
#include <string>
#include <system_error>

namespace squat::platform {

namespace fs = std::filesystem;

fs::path programPath() {
  std::uint32_t size = 0;
  ::_NSGetExecutablePath(nullptr, &size);
  std::string path(size, '\0');
  if (::_NSGetExecutablePath(path.data(), &size) != 0) return {};
  std::error_code error;
  fs::path program = fs::canonical(path.c_str(), error);
  return error ? fs::path() : program;
}

}  // namespace squat::platform
