// app/commands/ResultToRead.h - a result that a command works on.
#pragma once

#include <string>

#include "results/RunResult.h"

namespace squat::commands {

// results::readResult, and a warning on stderr of what a newer program has put into the file beyond that.
results::RunResult resultToRead(const std::string& path);

}  // namespace squat::commands
