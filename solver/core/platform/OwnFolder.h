// solver/core/platform/OwnFolder.h - a new folder that nobody else has.
#pragma once

#include <filesystem>
#include <string>

namespace squat::platform {

// Makes BEGINNING-??????, a name that was free, for this user alone. Empty where it cannot be made.
std::filesystem::path makeOwnFolder(const std::string& beginning);

}  // namespace squat::platform
