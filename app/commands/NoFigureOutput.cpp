// The headless build: no Qt, no VTK, no figures.
#include "commands/FigureOutput.h"
#include "core/Errors.h"

namespace squat::commands {

bool figuresAvailable() { return false; }

void checkFigureNames(const std::vector<std::string>&, const std::vector<std::string>&) {}

FigureOutput writeFigures(const results::RunResult&, const std::string&, const std::vector<std::string>&,
                          const std::vector<std::string>&) {
  throw CaseError({{"figures", "headless build", "a build with SQUAT_GRAPHICS=ON",
                    "Figures need the full build: cmake --preset release. The result file is the same; render it there "
                    "with squat render"}});
}

}  // namespace squat::commands
