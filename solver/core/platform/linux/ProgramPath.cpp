#include "core/platform/ProgramPath.h"

#include <system_error>

namespace squat::platform {

namespace fs = std::filesystem;

fs::path programPath() {
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program;
}

}  // namespace squat::platform
