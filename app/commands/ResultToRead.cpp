#include "commands/ResultToRead.h"

#include <cstdio>

#include "results/ResultFile.h"

namespace squat::commands {

results::RunResult resultToRead(const std::string& path) {
  auto result = results::readResult(path);
  if (!result.notRead.empty())
    std::fprintf(stderr, "warning: %s: this version does not read %s; install that one to see the rest\n", path.c_str(),
                 result.notRead.c_str());
  return result;
}

}  // namespace squat::commands
