// app/commands/Program.h - the whole command line as one function.
#pragma once

namespace squat::commands {

// Parses, acts, reports errors in one place. Returns the exit code of ExitCodes.h.
int runProgram(int argc, char** argv);

}  // namespace squat::commands
