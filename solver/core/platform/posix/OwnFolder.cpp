#include "core/platform/OwnFolder.h"

#include <stdlib.h>

namespace squat::platform {

std::filesystem::path makeOwnFolder(const std::string& beginning) {
  std::string name = beginning + "-XXXXXX";
  return ::mkdtemp(name.data()) ? std::filesystem::path(name) : std::filesystem::path();
}

}  // namespace squat::platform
