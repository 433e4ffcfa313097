#include "core/ProgramVersion.h"

namespace squat {

const char* programVersion() { return SQUAT_VERSION; }

std::string programVersionText() {
  const std::string commit = programCommit();
  return programVersion() + (commit.empty() ? "" : " (commit " + commit + ")");
}

}  // namespace squat
