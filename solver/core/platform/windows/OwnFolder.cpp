#include "core/platform/OwnFolder.h"

#include <random>
#include <system_error>

namespace squat::platform {

// Who may enter it is what the folder around it says: that of temporary files is the user's own.
std::filesystem::path makeOwnFolder(const std::string& beginning) {
  constexpr int tries = 100;
  constexpr char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";  // no case: names have none there
  std::random_device random;
  std::uniform_int_distribution<std::size_t> any(0, sizeof letters - 2);
  for (int attempt = 0; attempt < tries; ++attempt) {
    std::string name = beginning + "-";
    for (int i = 0; i < 6; ++i) name += letters[any(random)];
    std::error_code error;
    if (std::filesystem::create_directory(name, error)) return name;
    if (error) return {};
  }
  return {};
}

}  // namespace squat::platform
