#include "core/platform/CommandOutput.h"

#include <stdio.h>

#include <array>

namespace squat::platform {

CommandOutput outputOfCommand(const std::string& line) {
  CommandOutput output;
  FILE* pipe = ::_popen(line.c_str(), "rb");
  if (!pipe) return output;
  output.isStarted = true;
  std::array<char, 4096> piece{};
  while (const auto size = ::fread(piece.data(), 1, piece.size(), pipe)) output.text.append(piece.data(), size);
  output.isDone = ::_pclose(pipe) == 0;
  return output;
}

}  // namespace squat::platform
