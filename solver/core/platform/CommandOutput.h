// solver/core/platform/CommandOutput.h - what another program prints.
#pragma once

#include <string>

namespace squat::platform {

struct CommandOutput {
  bool isStarted = false;
  bool isDone = false;  // ended by itself, with code 0
  std::string text;     // of its standard output
};

// Runs `line`, as one types it into the system's shell, and waits for its end. What of it comes from others must be
// quoted.
CommandOutput outputOfCommand(const std::string& line);

}  // namespace squat::platform
