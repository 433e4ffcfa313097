// The headless build: no VTK, no files for ParaView.
#include "commands/VtkOutput.h"
#include "core/Errors.h"

namespace squat::commands {

namespace {

[[noreturn]] void refuse() {
  throw CaseError({{"squat", "a headless build", "a build with SQUAT_GRAPHICS=ON to write files for ParaView",
                    "Build with cmake --preset release and run squat export on the same result file"}});
}

}  // namespace

std::vector<std::string> writeVtkFiles(const results::RunResult&, const std::string&) { refuse(); }

std::vector<std::string> writeVtkFiles(const growth::SurfaceSeries&, const std::string&, const std::string&) {
  refuse();
}

}  // namespace squat::commands
