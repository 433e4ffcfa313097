// solver/core/platform/ProgramPath.h - the files that this code was started from.
#pragma once

#include <filesystem>

namespace squat::platform {

std::filesystem::path programPath();  // of the program that runs; empty: not known

// The shared library that this code is part of; empty where it is part of the program itself.
std::filesystem::path ownLibrary();

}  // namespace squat::platform
