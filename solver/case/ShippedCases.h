// solver/case/ShippedCases.h - cases that come with the program, found by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace squat::cases {

// Folder with cases/, profiles/ and reference/: the environment's SQUAT_RESOURCES where it is set, else beside the
// installed program or module of Python, else the source tree. Empty where there is none.
std::filesystem::path resourcesFolder();

// Names of the shipped cases ("light-defect"), sorted.
std::vector<std::string> shippedCases();

// Path of a case file: `nameOrPath` itself where such a file stands, else the shipped case of that name. Throws
// FileError with the names of all shipped cases.
std::filesystem::path findCase(const std::string& nameOrPath);

}  // namespace squat::cases
