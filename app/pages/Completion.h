// app/pages/Completion.h - completion of a program's commands, options and values in bash.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pages/HelpText.h"

namespace squat::pages {

// Each call ("squat", "squat run") with its help, the program itself first. The text of a file for bash-completion.
std::string completion(const std::vector<std::pair<std::string, HelpText>>& calls);

}  // namespace squat::pages
