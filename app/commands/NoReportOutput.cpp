// The headless build: no pages.
#include "commands/ReportOutput.h"
#include "core/Errors.h"

namespace squat::commands {

std::vector<std::string> writeReport(const project::Report&, const ReportChoice&, const std::string&) {
  throw CaseError({{"squat", "a headless build", "a build with SQUAT_GRAPHICS=ON to write a report",
                    "Build with cmake --preset release and run squat report on the same files"}});
}

}  // namespace squat::commands
