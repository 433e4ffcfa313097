// The headless build: no Qt, no VTK, no figures.
#include "commands/FigureOutput.h"
#include "core/Errors.h"

namespace squat::commands {

bool figuresAvailable() { return false; }

std::string figureList() { return {}; }

// The names of figures belong to the full build; formats are known here too.
void checkFigureNames(const NamedFigures& named, const cases::CaseDescription*) {
  for (const auto& format : named.formats)
    if (format != "png" && format != "svg" && format != "pdf")
      throw CaseError({{"--format", format, "png, svg or pdf", "This headless build draws no figures"}});
}

FigureOutput writeFigures(const results::RunResult&, const std::string&, const NamedFigures&) {
  throw CaseError({{"squat", "a headless build", "a build with SQUAT_GRAPHICS=ON to draw figures",
                    "Run squat render on the same result file with the full build: package squat-studio, or cmake "
                    "--preset release"}});
}

}  // namespace squat::commands
