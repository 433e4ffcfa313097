// solver/core/platform/Terminal.h - the standard streams, and the terminal behind them.
#pragma once

#include <cstddef>
#include <cstdio>

namespace squat::platform {

bool isTerminal(std::FILE* stream);
std::size_t columnsOfTerminal(std::FILE* stream);  // characters in a line of it; 0: not known

// To be called first of all. A file opened later would take the place of a closed stdout, and what is printed would end
// up in it. What nobody wants to see goes nowhere instead.
void keepStandardStreamsOpen();

}  // namespace squat::platform
