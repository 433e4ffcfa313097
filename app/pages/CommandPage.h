// app/pages/CommandPage.h - the manual's page of all commands and options.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pages/HelpText.h"

namespace squat::pages {

// Each call ("squat", "squat run", "squat-studio") with what it prints for --help, programs before their commands.
// Markdown: a section for each.
std::string commandPage(const std::vector<std::pair<std::string, HelpText>>& calls);

}  // namespace squat::pages
