// app/pages/Program.h - the help of an installed program and of its commands.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pages/HelpText.h"

namespace squat::pages {

// "squat" and all its commands, each with the help that the program at `path` prints. Throws std::runtime_error where
// it does not run or prints no help.
std::vector<std::pair<std::string, HelpText>> callsOf(const std::string& path);

}  // namespace squat::pages
